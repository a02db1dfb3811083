#pragma once

#include <string_view>

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Material.h"

namespace walkcycle {

// COLLADA's <transparency> is, with A_ONE, how opaque a material is. Replaces material.transparency, as it was read
// from the element `transparency` of an effect, where the quirks inverted-transparency and zero-transparency say that
// the exporter means something else.
void correctTransparency(XmlNode transparency, std::string_view effect, const LoadContext& context,
                         Material& material);

}  // namespace walkcycle
