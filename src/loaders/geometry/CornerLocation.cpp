#include "loaders/geometry/CornerLocation.h"

#include <algorithm>
#include <string>

#include "loaders/geometry/PrimitiveKind.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

// A fan or strip is cut into triangles or lines, whose corners are copies. Returns which corner of the <p>
// was copied to `corner`.
std::size_t cornerBeforeCut(PrimitiveKind kind, std::size_t corner) {
    const std::size_t size = kind == PrimitiveKind::Linestrips ? 2 : 3;
    const std::size_t ring = corner / size, nth = corner % size;
    if (kind == PrimitiveKind::Trifans && nth == 0) return 0;
    const bool swapped = kind == PrimitiveKind::Tristrips && ring % 2 == 1 && nth < 2;
    return ring + (swapped ? 1 - nth : nth);
}

bool isCut(PrimitiveKind kind) {
    return kind == PrimitiveKind::Trifans || kind == PrimitiveKind::Tristrips ||
           kind == PrimitiveKind::Linestrips;
}

// Finds a corner of a fan or a strip in the file.
CornerLocation findCutCorner(const PrimitiveCorners& primitive, PrimitiveKind kind, std::size_t corner,
                             std::size_t offset) {
    const std::size_t size = kind == PrimitiveKind::Linestrips ? 2 : 3, stride = primitive.inputs.stride;
    for (XmlNode p : primitive.element.children("p")) {
        std::string joined;
        const std::size_t held = countWords(p.rawText(joined)) / stride;
        const std::size_t cut = held < size ? 0 : (held - size + 1) * size;
        if (corner < cut) return {p, p.lineOfWord(cornerBeforeCut(kind, corner) * stride + offset)};
        corner -= cut;
    }
    return {primitive.element, primitive.element.line()};
}

}  // namespace

CornerLocation findCorner(const PrimitiveCorners& primitive, std::size_t corner, std::size_t offset) {
    const PrimitiveKind kind = *primitiveKindOf(primitive.element);
    if (isCut(kind)) return findCutCorner(primitive, kind, corner, offset);
    std::size_t number = corner * primitive.inputs.stride + offset;
    CornerLocation location{primitive.element, primitive.element.line()};
    const auto lookIn = [&](XmlNode p) {
        std::string joined;
        const std::size_t numbers = countWords(p.rawText(joined));
        if (number < numbers) location = {p, p.lineOfWord(number)};
        const bool found = number < numbers;
        number -= std::min(number, numbers);
        return found;
    };
    for (XmlNode child : primitive.element.children()) {
        if (child.is("p") && lookIn(child)) return location;
        if (!child.is("ph")) continue;
        for (XmlNode ring : child.children())
            if ((ring.is("p") || ring.is("h")) && lookIn(ring)) return location;
    }
    return location;
}

}  // namespace walkcycle
