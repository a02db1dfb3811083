#include "loaders/ExporterQuirks.h"

#include <charconv>

namespace walkcycle {
namespace {

// "Google SketchUp 6.4.112": versions before 7.1 are meant.
bool isOldSketchUp(std::string_view tool) {
    constexpr std::string_view kName = "Google SketchUp ";
    const std::size_t at = tool.find(kName);
    if (at == std::string_view::npos) return false;
    int major = 0, minor = 0;
    const char* end = tool.data() + tool.size();
    const auto [next, error] = std::from_chars(tool.data() + at + kName.size(), end, major);
    if (error != std::errc()) return false;
    if (next != end && *next == '.') std::from_chars(next + 1, end, minor);
    return major < 7 || (major == 7 && minor < 1);
}

std::string shortText(float number) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, number);
    return error == std::errc() ? std::string(text, end) : std::string();
}

}  // namespace

void correctTransparency(const Asset& asset, XmlNode effect, Diagnostics& diagnostics, Material& material) {
    if (material.opaque != OpaqueMode::AOne) return;
    const float written = material.transparency;
    const char* reason = "nothing would be seen of it otherwise";
    if (isOldSketchUp(asset.authoringTool)) {
        material.transparency = 1.0f - material.transparency;
        reason = "this exporter writes it the other way round";
    }
    if (material.transparency <= 0.0f) material.transparency = 1.0f;
    if (material.transparency == written) return;
    diagnostics.report(
        Code::TransparencyInverted, effect,
        {std::string(effect.id()), shortText(written), shortText(material.transparency), reason});
}

}  // namespace walkcycle
