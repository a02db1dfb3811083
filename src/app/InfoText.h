#pragma once

#include <string>

#include "loaders/quirks/Dialect.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The output of `info` about a file, as text for people and as JSON for programs. If `dialect` is null, the text does
// not have the dialect and its quirks.
std::string infoText(const Model& model, const Dialect* dialect = nullptr);
std::string infoJson(const Model& model, const Dialect& dialect);

// The exporter's name and version: "ColladaMaya 2.3", "Blender". Empty if the exporter is unknown.
std::string exporterText(const Exporter& exporter);

}  // namespace walkcycle
