#pragma once

#include <string_view>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "loaders/quirks/Dialect.h"
#include "walkcycle/model/Material.h"

namespace walkcycle {

// COLLADA's <transparency> is, with A_ONE, how opaque a material is. Replaces material.transparency, as it was read
// from the element `transparency` of an effect, where the quirks inverted-transparency and zero-transparency say that
// the exporter means something else.
void correctTransparency(XmlNode transparency, std::string_view effect, Dialects& dialects,
                         Diagnostics& diagnostics, Material& material);

}  // namespace walkcycle
