#pragma once

#include <string_view>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "loaders/quirks/Dialect.h"
#include "walkcycle/model/Material.h"

namespace walkcycle {

// With A_ONE, COLLADA's <transparency> is a material's opacity. Some exporters mean something else: applies the quirks
// inverted-transparency and zero-transparency to material.transparency, which was read from the element `transparency`
// of the effect named `effect`, and reports the change.
void correctTransparency(XmlNode transparency, std::string_view effect, Dialects& dialects,
                         Diagnostics& diagnostics, Material& material);

}  // namespace walkcycle
