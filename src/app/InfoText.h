#pragma once

#include <string>

#include "loaders/quirks/Dialect.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// What `info` prints about a file, for people and (as JSON) for programs. The text leaves the dialect out if it is
// null.
std::string infoText(const Model& model, const Dialect* dialect = nullptr);
std::string infoJson(const Model& model, const Dialect& dialect);

// "ColladaMaya 2.3", "Blender"; empty for an exporter that is not known.
std::string exporterText(const Exporter& exporter);

}  // namespace walkcycle
