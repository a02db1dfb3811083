#include "loaders/sources/Inputs.h"

#include <cstdint>
#include <utility>

#include "loaders/text/NumberParser.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace {

// COLLADA 1.4.1, "Common Glossary": all semantics but those of samplers.
constexpr std::string_view kSemantics =
    "BINORMAL COLOR CONTINUITY IMAGE INPUT INV_BIND_MATRIX JOINT LINEAR_STEPS MORPH_TARGET MORPH_WEIGHT "
    "NORMAL OUTPUT POSITION TANGENT TEXBINORMAL TEXCOORD TEXTANGENT UV VERTEX WEIGHT";

}  // namespace

void checkSemantic(XmlNode input, std::string_view known, Diagnostics& diagnostics) {
    const std::string_view semantic = input.attribute("semantic");
    if (semantic.empty()) return diagnostics.report(Code::MissingAttribute, input, {"input", "semantic"});
    const std::string padded = " " + std::string(semantic) + " ";
    if ((" " + std::string(known) + " ").find(padded) != std::string::npos) return;
    const std::string meant = didYouMean(semantic, known);
    diagnostics.report(meant.empty() ? Severity::Info : Severity::Warning, Code::WordUnknown, input,
                       {std::string(semantic), "input", meant});
}

std::vector<Input> readInputs(XmlNode parent, DocumentSet& documents, Diagnostics& diagnostics) {
    std::vector<Input> inputs;
    for (XmlNode element : parent.children("input")) {
        Input input;
        input.element = element;
        input.semantic = element.attribute("semantic");
        std::int32_t number = 0;
        for (const char* attribute : {"offset", "set"}) {
            if (!element.has(attribute)) continue;
            if (!parseNumber(element.attribute(attribute), number) || number < 0) {
                diagnostics.report(
                    Code::NumberInvalid, element,
                    {std::string(element.attribute(attribute)), std::string("input ") + attribute});
                number = 0;
            }
            (*attribute == 'o' ? input.offset : input.set) = number;
        }
        input.hasSet = element.has("set");
        checkSemantic(element, kSemantics, diagnostics);
        // Without INTERPOLATION the keys are blended linearly.
        const bool canDoWithout = input.semantic == "INTERPOLATION";
        input.source =
            documents.follow(element, "source", {}, canDoWithout ? Severity::Warning : Severity::Error);
        inputs.push_back(std::move(input));
    }
    return inputs;
}

}  // namespace walkcycle
