#include "loaders/quirks/TransparencyQuirk.h"

#include <charconv>
#include <string>

namespace walkcycle {
namespace {

std::string shortText(float number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace

void correctTransparency(XmlNode transparency, std::string_view effect, Dialects& dialects,
                         Diagnostics& diagnostics, Material& material) {
    if (material.opaque != OpaqueMode::AOne) return;
    const float written = material.transparency;
    const char* reason = "it would be invisible otherwise";
    if (dialects.follows(Quirk::InvertedTransparency, transparency)) {
        material.transparency = 1.0f - written;
        reason = "this exporter writes how transparent a material is";
        dialects.note(Quirk::InvertedTransparency, transparency);
    }
    if (material.transparency <= 0.0f && dialects.follows(Quirk::ZeroTransparency, transparency)) {
        material.transparency = 1.0f;
        dialects.note(Quirk::ZeroTransparency, transparency);
    }
    if (material.transparency == written) return;
    diagnostics.report(Code::TransparencyInverted, transparency,
                       {std::string(effect), shortText(written), shortText(material.transparency), reason});
}

}  // namespace walkcycle
