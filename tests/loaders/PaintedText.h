#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "walkcycle/io/Image.h"

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

// A triangle shown with so many pictures one after the other: 0.png, 1.png ...
inline std::string withPictures(int count) {
    std::string images, effects, materials, bindings;
    for (int i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        images += "<image id='i" + n + "'><init_from>" + n + ".png</init_from></image>";
        effects += "<effect id='e" + n +
                   "'><profile_COMMON><technique sid='c'><lambert><diffuse><texture texture='i" + n +
                   "' texcoord='UV'/></diffuse></lambert></technique></profile_COMMON></effect>";
        materials += "<material id='m" + n + "'><instance_effect url='#e" + n + "'/></material>";
        bindings +=
            "<node><instance_geometry url='#mesh'><bind_material><technique_common><instance_material "
            "symbol='paint' target='#m" +
            n + "'/></technique_common></bind_material></instance_geometry></node>";
    }
    std::string mesh = triangle();
    mesh.insert(mesh.find("<triangles") + 10, " material='paint'");
    return collada("<library_images>" + images + "</library_images><library_effects>" + effects +
                   "</library_effects><library_materials>" + materials + "</library_materials>" + mesh +
                   scene(bindings));
}

}  // namespace walkcycle
