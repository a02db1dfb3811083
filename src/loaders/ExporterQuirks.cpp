#include "loaders/ExporterQuirks.h"

#include <algorithm>
#include <charconv>

#include "loaders/NumberParser.h"

namespace walkcycle {
namespace {

// "Google SketchUp 6.4.112": versions before 7.1 are meant.
bool isOldSketchUp(std::string_view tool) {
    constexpr std::string_view kName = "Google SketchUp ";
    const std::size_t at = tool.find(kName);
    if (at == std::string_view::npos) return false;
    const std::string_view version = tool.substr(at + kName.size());
    const std::size_t dot = std::min(version.find('.'), version.size());
    const std::string_view rest = version.substr(std::min(dot + 1, version.size()));
    std::int32_t major = 0, minor = 0;
    if (!parseNumber(version.substr(0, dot), major)) return false;
    if (!parseNumber(rest.substr(0, rest.find('.')), minor)) minor = 0;
    return major < 7 || (major == 7 && minor < 1);
}

std::string shortText(float number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace

void correctTransparency(const Asset& asset, XmlNode transparency, std::string_view effect,
                         Diagnostics& diagnostics, Material& material) {
    if (material.opaque != OpaqueMode::AOne) return;
    const float written = material.transparency;
    const char* reason = "nothing would be seen of it otherwise";
    if (isOldSketchUp(asset.authoringTool)) {
        material.transparency = 1.0f - material.transparency;
        reason = "this exporter writes it the other way round";
    }
    if (material.transparency <= 0.0f) material.transparency = 1.0f;
    if (material.transparency == written) return;
    diagnostics.report(Code::TransparencyInverted, transparency,
                       {std::string(effect), shortText(written), shortText(material.transparency), reason});
}

}  // namespace walkcycle
