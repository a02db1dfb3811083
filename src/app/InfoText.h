#pragma once

#include <string>

#include "model/Model.h"

namespace walkcycle {

// What is in a file, for people and for programs.
std::string infoText(const Model& model);
std::string infoJson(const Model& model);

}  // namespace walkcycle
