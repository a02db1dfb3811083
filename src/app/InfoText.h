#pragma once

#include <string>

#include "model/Model.h"

namespace walkcycle {

// What `info` prints about a file, for people and (as JSON) for programs.
std::string infoText(const Model& model);
std::string infoJson(const Model& model);

}  // namespace walkcycle
