#pragma once

#include <string>

#include "io/Image.h"
#include "loaders/LoadText.h"

namespace walkcycle {

// A triangle whose material "m" has the effect "e", to be changed piece by piece. The images "picture" (two by two, no
// two texels alike, a hole in it), "solid" (the same without the hole) and "grey" are there.
struct PaintedText {
    std::string shader{};  // inside <phong>
    std::string params{};  // of the profile, before its technique
    std::string extra{};   // of the technique
    std::string images{};  // more <image>s
    std::string materials = "<material id='m'><instance_effect url='#e'/></material>";
    std::string symbol = "m";

    static std::string hexOf(const Bytes& rgba) {
        const Image image{.width = 2, .height = 2, .hasAlpha = true, .rgba = rgba};
        std::string hex;
        for (const std::uint8_t byte : encodePng(image)) {
            hex += "0123456789abcdef"[byte / 16];
            hex += "0123456789abcdef"[byte % 16];
        }
        return hex;
    }
    static std::string pictureHex() {
        return hexOf({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 0});
    }
    std::string text() const {
        std::string geometry = triangle();
        geometry.replace(geometry.find("<triangles"), 10, "<triangles material='" + symbol + "'");
        return collada(
            "<library_images><image id='picture' name='Named'><data>" + pictureHex() +
            "</data></image><image id='solid'><data>" +
            hexOf({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 9, 255}) +
            "</data></image><image id='grey'><data>" +
            hexOf({0, 0, 0, 255, 99, 99, 99, 255, 0, 0, 0, 255, 99, 99, 99, 255}) + "</data></image>" +
            images + "</library_images>\n<library_effects><effect id='e'><profile_COMMON>\n" + params +
            "\n<technique sid='t'><phong>\n" + shader + "\n</phong>" + extra +
            "</technique></profile_COMMON></effect></library_effects><library_materials>" + materials +
            "</library_materials>" + geometry + scene("<node><instance_geometry url='#mesh'/></node>"));
    }
    // What is worth a warning; that the triangle has no texture coordinates is another matter.
    static std::vector<Diagnostic> warnings(const Model& model) {
        std::vector<Diagnostic> found;
        for (const Diagnostic& said : model.diagnostics)
            if (said.severity == Severity::Warning && said.code != "WC0613") found.push_back(said);
        return found;
    }
};

}  // namespace walkcycle
