#include "loaders/materials/TexCoordBinding.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "loaders/quirks/Dialect.h"
#include "loaders/text/NumberParser.h"

namespace walkcycle {
namespace {

int indexOfSet(const MeshData& mesh, int set) {
    for (std::size_t i = 0; i < mesh.texCoordSets.size(); ++i)
        if (mesh.texCoordSets[i].set == set) return static_cast<int>(i);
    return -1;
}

// "UVSET1", "TEX1", "CHANNEL1" and "uv1" mean set 1 or, if no set has that number, the second set.
int guessFromName(std::string_view name, const MeshData& mesh) {
    std::size_t digits = name.size();
    while (digits > 0 && name[digits - 1] >= '0' && name[digits - 1] <= '9') --digits;
    std::int32_t number = 0;
    if (digits == name.size() || !parseNumber(name.substr(digits), number)) return 0;
    if (const int index = indexOfSet(mesh, number); index >= 0) return index;
    return number < static_cast<int>(mesh.texCoordSets.size()) ? number : 0;
}

int chooseSet(const std::string& name, XmlNode binding, const MeshData& mesh, const LoadContext& context) {
    for (XmlNode input : binding.children("bind_vertex_input")) {
        if (input.attribute("semantic") != name) continue;
        std::int32_t set = 0;
        if (input.has("input_set") && !parseNumber(input.attribute("input_set"), set))
            context.diagnostics.report(
                Code::NumberOddWarning, input,
                {std::string(input.attribute("input_set")), "bind_vertex_input input_set", "0"});
        if (const int index = indexOfSet(mesh, set); index >= 0) return index;
        context.diagnostics.report(Code::TexCoordsGuessed, input, {name, std::to_string(set), mesh.id});
        return 0;
    }
    if (!context.dialects.follows(Quirk::TexCoordByNumber, binding)) return 0;
    const int index = guessFromName(name, mesh);
    if (index != 0) context.dialects.note(Quirk::TexCoordByNumber, binding);
    return index;
}

}  // namespace

void bindTexCoords(const Material& material, XmlNode binding, const MeshData& mesh, const MeshPart& part,
                   const LoadContext& context, PartMaterial& bound) {
    bool missing = false;
    for (std::size_t slot = 0; slot < material.slots.size(); ++slot) {
        const ColorOrTexture& source = material.slots[slot];
        if (source.texture < 0) continue;
        if (mesh.texCoordSets.empty())
            missing = true;
        else
            bound.texCoordSets[slot] = chooseSet(source.texCoordName, binding, mesh, context);
    }
    if (missing && part.primitive == Primitive::Triangles)
        context.diagnostics.report(Code::TexCoordsMissing, binding, {mesh.id, material.id});
}

}  // namespace walkcycle
