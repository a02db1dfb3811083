#include "loaders/geometry/PrimitiveKind.h"

#include <algorithm>
#include <array>

namespace walkcycle {
namespace {

struct KindName {
    const char* name;
    PrimitiveKind kind;
};
constexpr std::array<KindName, 7> kKinds{{{"triangles", PrimitiveKind::Triangles},
                                          {"polylist", PrimitiveKind::Polylist},
                                          {"polygons", PrimitiveKind::Polygons},
                                          {"trifans", PrimitiveKind::Trifans},
                                          {"tristrips", PrimitiveKind::Tristrips},
                                          {"lines", PrimitiveKind::Lines},
                                          {"linestrips", PrimitiveKind::Linestrips}}};

}  // namespace

std::optional<PrimitiveKind> primitiveKindOf(XmlNode element) {
    const auto found =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const KindName& k) { return element.is(k.name); });
    return found == kKinds.end() ? std::nullopt : std::optional(found->kind);
}

}  // namespace walkcycle
