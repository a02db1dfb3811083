#include "loaders/context/AssetReader.h"

#include <optional>
#include <string>
#include <string_view>

#include <glm/gtc/matrix_transform.hpp>

#include "loaders/quirks/Dialect.h"
#include "loaders/text/NumberParser.h"

namespace walkcycle {
namespace {

std::optional<UpAxis> parseUpAxis(std::string_view text) {
    if (text == "X_UP") return UpAxis::X;
    if (text == "Y_UP") return UpAxis::Y;
    if (text == "Z_UP") return UpAxis::Z;
    return std::nullopt;
}

std::optional<double> parseUnit(XmlNode unit) {
    double meters = 0.0;
    if (!unit || !parseNumber(unit.attribute("meter"), meters) || !isUsableUnit(meters)) return std::nullopt;
    return meters;
}

struct Space {
    std::optional<double> metersPerUnit;
    std::optional<UpAxis> upAxis;
};

// Unit and up axis for an element, from the nearest <asset>s on the way up; the two may come from different ones.
Space spaceOf(XmlNode element, const Asset& document, XmlNode rootCollada) {
    Space space;
    for (; element; element = element.parent()) {
        if (element == rootCollada) break;
        // The schema puts <asset> first; looking there alone avoids a search through many siblings.
        const XmlNode first = element.firstChild();
        const XmlNode asset = first.is("asset") ? first : XmlNode();
        if (!space.metersPerUnit) space.metersPerUnit = parseUnit(asset.child("unit"));
        if (!space.upAxis && asset.child("up_axis"))
            space.upAxis = parseUpAxis(asset.child("up_axis").text());
    }
    const bool inRootDocument = element == rootCollada && element;
    if (!space.metersPerUnit) space.metersPerUnit = inRootDocument ? document.metersPerUnit : 1.0;
    if (!space.upAxis) space.upAxis = inRootDocument ? document.upAxis : UpAxis::Y;
    return space;
}

bool same(const Space& a, const Space& b) {
    return a.metersPerUnit == b.metersPerUnit && a.upAxis == b.upAxis;
}

}  // namespace

Asset readAsset(XmlNode collada, const LoadContext& context) {
    Asset asset;
    asset.version = collada.attribute("version");
    const XmlNode element = collada.child("asset");
    asset.authoringTool = context.dialects.of(collada).authoringTool();
    if (const XmlNode unit = element.child("unit")) {
        if (!unit.attribute("name").empty()) asset.unitName = unit.attribute("name");
        const std::optional<double> meters = unit.has("meter") ? parseUnit(unit) : 1.0;
        if (!meters)
            context.diagnostics.report(Code::BadAsset, unit,
                                       {"unit", std::string(unit.attribute("meter")), "1 metre"});
        asset.metersPerUnit = meters.value_or(1.0);
    }
    if (const XmlNode up = element.child("up_axis")) {
        const std::optional<UpAxis> axis = parseUpAxis(up.text());
        if (!axis) context.diagnostics.report(Code::BadAsset, up, {"up_axis", up.text(), "Y_UP"});
        asset.upAxis = axis.value_or(UpAxis::Y);
    }
    asset.upAxis = context.options.upAxis.value_or(asset.upAxis);
    asset.metersPerUnit = context.options.metersPerUnit.value_or(asset.metersPerUnit);
    return asset;
}

glm::dmat4 toMetresYUp(double metersPerUnit, UpAxis upAxis) {
    glm::dmat4 axes(1.0);
    if (upAxis == UpAxis::X) axes = glm::dmat4({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    if (upAxis == UpAxis::Z) axes = glm::dmat4({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
    return glm::scale(glm::dmat4(1.0), glm::dvec3(metersPerUnit)) * axes;
}

glm::dmat4 assetConversion(XmlNode element, XmlNode around, const Asset& document, XmlNode rootCollada) {
    const Space inner = spaceOf(element, document, rootCollada);
    const Space outer = spaceOf(around, document, rootCollada);
    if (same(inner, outer)) return glm::dmat4(1.0);
    return glm::inverse(toMetresYUp(*outer.metersPerUnit, *outer.upAxis)) *
           toMetresYUp(*inner.metersPerUnit, *inner.upAxis);
}

}  // namespace walkcycle
