#include "loaders/geometry/PrimitiveInputs.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "loaders/sources/Inputs.h"

namespace walkcycle {
namespace {

// Inputs may share their indices and sources, so a short file could name millions of sets.
constexpr std::size_t kMaxTexCoordSets = 32;

// Reports a source with too few or too many numbers per entry for its semantic.
void checkWidth(const Input& input, const FloatSource& source, std::size_t least, std::size_t most,
                const LoadContext& context) {
    if (source.width >= least && source.width <= most) return;
    context.diagnostics.report(Code::SourceWidth, input.element,
                               {input.semantic, std::to_string(source.width), std::to_string(least)});
}

std::shared_ptr<const FloatSource> readFloats(const Input& input, std::size_t least, std::size_t most,
                                              NumberFaults faultsAre, const LoadContext& context) {
    if (!input.source) return nullptr;  // already reported
    if (!input.source.is("source")) {
        context.diagnostics.report(Code::WrongElement, input.element,
                                   {"input", std::string(input.element.attribute("source")),
                                    std::string(input.source.name()), "source"});
        return nullptr;
    }
    auto source = context.sources.floats(input.source, faultsAre);
    if (source) checkWidth(input, *source, least, most, context);
    return source;
}

// Each set needs a number of its own. If `wanted` is taken, returns the lowest free number.
int freeSet(const std::vector<CornerInput>& taken, int wanted) {
    const auto isTaken = [&](int set) {
        return std::any_of(taken.begin(), taken.end(), [&](const CornerInput& t) { return t.set == set; });
    };
    if (!isTaken(wanted)) return wanted;
    int set = 0;
    while (isTaken(set)) ++set;
    return set;
}

// Adds one <input> of a primitive or of <vertices>. The first input of a semantic counts; each TEXCOORD is a
// set.
void addInput(PrimitiveInputs& inputs, const Input& input, std::size_t offset, const LoadContext& context) {
    if (input.semantic == "POSITION" && !inputs.position.source) {
        inputs.position = {readFloats(input, 2, 4, NumberFaults::Error, context), offset, 0};
    } else if (input.semantic == "NORMAL" && !inputs.normal.source) {
        inputs.normal = {readFloats(input, 3, 3, NumberFaults::Warning, context), offset, 0};
    } else if (input.semantic == "COLOR" && !inputs.color.source) {
        inputs.color = {readFloats(input, 3, 4, NumberFaults::Warning, context), offset, 0};
    } else if (input.semantic == "TEXCOORD") {
        auto source = readFloats(input, 1, 4, NumberFaults::Warning, context);
        if (!source) return;
        if (inputs.texCoords.size() == kMaxTexCoordSets)
            return context.diagnostics.report(Code::TooManyTexCoordSets, input.element,
                                              {std::to_string(kMaxTexCoordSets)});
        const int set = freeSet(inputs.texCoords, input.hasSet ? input.set : 0);
        inputs.texCoords.push_back({std::move(source), offset, set});
    }
}

bool hasSemantic(XmlNode element, std::string_view semantic) {
    for (XmlNode input : element.children("input"))
        if (input.attribute("semantic") == semantic) return true;
    return false;
}

// Adds the inputs of <vertices> that the primitive does not have itself.
void addVertices(PrimitiveInputs& inputs, const PrimitiveInputs& vertices, std::size_t offset) {
    const auto takeFrom = [&](CornerInput& own, const CornerInput& theirs) {
        if (!own.source) own = {theirs.source, offset, theirs.set};
    };
    takeFrom(inputs.position, vertices.position);
    takeFrom(inputs.normal, vertices.normal);
    takeFrom(inputs.color, vertices.color);
    for (const CornerInput& input : vertices.texCoords)
        inputs.texCoords.push_back({input.source, offset, freeSet(inputs.texCoords, input.set)});
}

// Adds what the VERTEX input refers to: <vertices>. If it refers to a <source>, it is reported, and read as
// the POSITION.
void addVertexInput(PrimitiveInputs& inputs, const Input& input, const Vertices& vertices,
                    const LoadContext& context) {
    const auto offset = static_cast<std::size_t>(input.offset);
    // A reference that leads nowhere is reported already. A mesh has only one <vertices>, so that one is
    // meant.
    if (!input.source || input.source == vertices.element)
        return addVertices(inputs, vertices.inputs, offset);
    if (input.source.is("vertices"))  // those of another mesh
        return addVertices(inputs, readVertices(input.source, context).inputs, offset);
    context.diagnostics.report(Code::WrongElement, input.element,
                               {"input", std::string(input.element.attribute("source")),
                                std::string(input.source.name()), "vertices"});
    if (!input.source.is("source") || inputs.position.source) return;
    Input position = input;
    position.semantic = "POSITION";
    addInput(inputs, position, offset, context);
}

}  // namespace

Vertices readVertices(XmlNode element, const LoadContext& context) {
    Vertices vertices{element, {}};
    for (const Input& input : readInputs(element, context.documents, context.diagnostics))
        addInput(vertices.inputs, input, 0, context);
    if (!hasSemantic(element, "POSITION"))
        context.diagnostics.report(Code::InputMissing, element, {"vertices", "POSITION"});
    return vertices;
}

PrimitiveInputs readPrimitiveInputs(XmlNode primitive, const Vertices& vertices, const LoadContext& context) {
    PrimitiveInputs inputs;
    const std::vector<Input> all = readInputs(primitive, context.documents, context.diagnostics);
    for (const Input& input : all)
        inputs.stride = std::max(inputs.stride, static_cast<std::size_t>(input.offset) + 1);
    // The primitive's own inputs come first, because they win over inputs of <vertices> with the same
    // semantic.
    for (const Input& input : all)
        if (input.semantic != "VERTEX")
            addInput(inputs, input, static_cast<std::size_t>(input.offset), context);
    for (const Input& input : all)
        if (input.semantic == "VERTEX") addVertexInput(inputs, input, vertices, context);
    if (!hasSemantic(primitive, "VERTEX") && !hasSemantic(primitive, "POSITION"))
        context.diagnostics.report(Code::InputMissing, primitive, {std::string(primitive.name()), "VERTEX"});
    return inputs;
}

}  // namespace walkcycle
