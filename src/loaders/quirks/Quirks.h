#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace walkcycle {

// The exporters that the rules below and `info --verbose` distinguish.
enum class Tool : std::uint8_t {
    Unknown,
    ColladaMaya,
    ColladaMax,
    OpenCollada,
    Softimage,
    Mixamo,
    FbxCollada,
    SceneKit,
    SketchUp,
    Blender,
    FCollada
};

struct ToolInfo {
    Tool tool;
    std::string_view name;  // as <authoring_tool> has it; case does not matter
};

// An <authoring_tool> often names several: "Maya 8.0 | ColladaMaya v3.02 | FCollada v3.2". The exporter is the first row
// whose name it contains; so plug-ins come before the programs and libraries around them.
inline constexpr ToolInfo kTools[] = {{Tool::ColladaMaya, "ColladaMaya"},
                                      {Tool::ColladaMax, "ColladaMax"},
                                      {Tool::OpenCollada, "OpenCOLLADA"},
                                      {Tool::Softimage, "Softimage"},
                                      {Tool::Mixamo, "COLLADA Mixamo exporter"},
                                      {Tool::FbxCollada, "FBX COLLADA exporter"},
                                      {Tool::SceneKit, "SceneKit"},
                                      {Tool::SketchUp, "SketchUp"},
                                      {Tool::Blender, "Blender"},
                                      {Tool::FCollada, "FCollada"}};

constexpr std::string_view nameOf(Tool tool) {
    for (const ToolInfo& info : kTools)
        if (info.tool == tool) return info.name;
    return "unknown";
}

struct ToolVersion {  // "v2.03b" is 2 and 3
    int major = 0, minor = 0;
    auto operator<=>(const ToolVersion&) const = default;
};

// Versions of a tool: `from` and later, but earlier than `before`. {0, 0} sets no bound.
struct ToolRange {
    Tool tool = Tool::Unknown;
    ToolVersion from{}, before{};
};

// The ways to read files that the specification does not describe, or contradicts. kQuirks has the rule of each.
enum class Quirk : std::uint8_t {
    SkinByNode,
    InvertedTransparency,
    ZeroTransparency,
    SpacedNames,
    JointsByAnyName,
    MorphWeightsByController,
    ForgottenStride,
    SingleNumberTangents,
    ExtraInfinity,
    ExtraVisibility,
    ExtraDoubleSided,
    ExtraBump,
    TextureNamesImage,
    MaterialBySymbol,
    TexCoordByNumber
};

struct QuirkInfo {
    Quirk quirk;
    std::string_view name;      // in LoadOptions::quirks, --quirk NAME=on and tests/fixtures/quirks/NAME.dae
    std::string_view rule;      // one sentence: how files are read with the quirk
    std::string_view evidence;  // why: the specification's words, and what files and programs do
    std::string_view code;      // of the message that reports its use; empty: not reported
    std::array<ToolRange, 2> tools{};  // exporters whose files it is on for; none given: on for all files
};

// All quirks, in the order of the enum. A new quirk needs a row here, a call of Dialects::follows() in the code that reads
// the file, a fixture and a test. docs/collada-notes.md lists these rows.
inline constexpr QuirkInfo kQuirks[] = {
    {Quirk::SkinByNode,
     "skin-by-node",
     "The transform of an <instance_controller>'s node, relative to the nearest common ancestor of node "
     "and joints, is applied on top of the joints.",
     "The skinning formula of chapter 4 places a skin by its joints alone. Four independent programs "
     "agree on that in files of Blender, OpenCOLLADA, FBX exporters and SceneKit, also where the node "
     "has a transform of its own. In files of ColladaMaya and Softimage the suite's pictures show the "
     "node's transform on top. Nothing but <authoring_tool> tells them apart.",
     "WC0406",
     {{{Tool::ColladaMaya}, {Tool::Softimage}}}},
    {Quirk::InvertedTransparency,
     "inverted-transparency",
     "With A_ONE, <transparency> is how transparent a material is, not how opaque.",
     "Chapter 7, \"Determining Transparency (Opacity)\", says the opposite. OpenCOLLADA and "
     "OpenSceneGraph invert the number for the same versions.",
     "WC0611",
     {{{Tool::SketchUp, {}, {7, 1}}}}},
    {Quirk::ZeroTransparency, "zero-transparency", "With A_ONE, a <transparency> of 0 is read as 1, opaque.",
     "Several exporters, such as the scripts of Blender 2.4, write 0 for what is simply solid, and "
     "nobody exports what cannot be seen. An alpha of 0, or white with RGB_ZERO, stays invisible: the "
     "suite asks for it.",
     "WC0611"},
    {Quirk::SpacedNames, "spaced-names",
     "The words of a <Name_array> that holds more words than its count are joined into names that nodes "
     "have.",
     "A Name_array is a list of words (chapter 5, \"Name_array\"), but exporters of 3ds Max write names "
     "such as \"Bip01 L Thigh\" into it.",
     "WC0120"},
    {Quirk::JointsByAnyName, "joints-by-any-name",
     "If no node has the sid that a skin gives for a joint, the joint is found by id or name; if none "
     "has the id, by sid or name.",
     "Chapter 5, \"skin\" and \"skeleton\": a Name_array holds sids, an IDREF_array ids. Some exporters "
     "write ids or names into a Name_array.",
     "WC0120"},
    {Quirk::MorphWeightsByController, "morph-weights-by-controller",
     "A channel whose target begins with a morph controller's id and leads nowhere moves the morph's "
     "weights.",
     "What follows the controller's id differs between exporters, and a morph has nothing else that "
     "moves (chapter 5, \"morph\").",
     "WC0120"},
    {Quirk::ForgottenStride, "forgotten-stride",
     "An OUTPUT source of a sampler that has 3, 4 or 16 single numbers for every key holds one vector or "
     "matrix per key.",
     "The stride is 1 unless the accessor says otherwise (chapter 5, \"accessor\"), and some exporters "
     "forget it. That many single values make sense in no other way.",
     "WC0306"},
    {Quirk::SingleNumberTangents, "single-number-tangents",
     "A BEZIER or HERMITE tangent of one number per value has no time of its own; control points stand "
     "at thirds of the time.",
     "Chapter 4, \"Curve Interpolation\", has (time, value) pairs only. Exporters of COLLADA 1.4.0's "
     "time wrote the value alone.",
     "WC0120"},
    {Quirk::ExtraInfinity, "extra-infinity",
     "<pre_infinity> and <post_infinity> in an <extra> or <technique> say how a curve goes on outside "
     "its keys.",
     "ColladaMaya and FCollada write them. COLLADA 1.5.0 has pre_behavior and post_behavior for the "
     "same, with GRADIENT for their LINEAR.",
     "WC0120"},
    {Quirk::ExtraVisibility, "extra-visibility", "A <visibility> of 0 in a node's <extra> hides the node.",
     "FCollada, and so ColladaMaya and ColladaMax, writes it, and animates it.", "WC0120"},
    {Quirk::ExtraDoubleSided, "extra-double-sided",
     "A <double_sided> of 1 in the <extra> of a geometry or an effect makes both sides of its faces "
     "visible.",
     "ColladaMaya and ColladaMax write it for geometries, Blender and SketchUp (profile GOOGLEEARTH) for "
     "effects.",
     ""},
    {Quirk::ExtraBump, "extra-bump", "A <bump> in an effect's <extra> is a map of heights or normals.",
     "FCollada, ColladaMax and Blender write it (profile FCOLLADA and others). Blender's are maps of "
     "normals, 3ds Max's of heights. The attribute bumptype says which, or else the colours: grey "
     "pictures are heights.",
     "WC0120"},
    {Quirk::TextureNamesImage, "texture-names-image",
     "A <texture> that names an <image> where a sampler belongs shows that image.",
     "Chapter 8, \"texture\", wants a sampler. Older exporters leave out the sampler and its surface.",
     "WC0609"},
    {Quirk::MaterialBySymbol, "material-by-symbol",
     "A part whose material symbol is not bound gets the material that has the symbol as its id or name.",
     "Some exporters leave out <bind_material>, without which a symbol means nothing (chapter 5, "
     "\"bind_material\").",
     "WC0603"},
    {Quirk::TexCoordByNumber, "texcoord-by-number",
     "Where no <bind_vertex_input> binds a <texture>'s texcoord, the number at the end of its name is "
     "the input set.",
     "Exporters call their sets UVSET1, TEX1, CHANNEL1 or the like, and some leave out the binding.",
     "WC0120"}};

inline constexpr std::size_t kQuirkCount = std::size(kQuirks);

constexpr const QuirkInfo& infoOf(Quirk quirk) {
    return kQuirks[static_cast<std::size_t>(quirk)];
}

// Null if there is no quirk of that name.
constexpr const QuirkInfo* findQuirk(std::string_view name) {
    for (const QuirkInfo& info : kQuirks)
        if (info.name == name) return &info;
    return nullptr;
}

// "there is no quirk 'spaced-name'; perhaps 'spaced-names' is meant", for a name that findQuirk() does not know.
std::string unknownQuirk(std::string_view name);

inline std::string textOf(ToolVersion version) {
    return std::to_string(version.major) + "." + std::to_string(version.minor);
}

// "ColladaMaya, Softimage", "SketchUp before 7.1"; empty for a quirk that no tool decides.
inline std::string toolsOf(const QuirkInfo& info) {
    std::string text;
    for (const ToolRange& range : info.tools) {
        if (range.tool == Tool::Unknown) continue;
        text += (text.empty() ? "" : ", ") + std::string(nameOf(range.tool));
        if (range.from != ToolVersion{}) text += " from " + textOf(range.from);
        if (range.before != ToolVersion{}) text += " before " + textOf(range.before);
    }
    return text;
}

}  // namespace walkcycle
