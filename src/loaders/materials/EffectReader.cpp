#include "loaders/materials/EffectReader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "loaders/materials/BumpMap.h"
#include "loaders/quirks/Dialect.h"
#include "loaders/quirks/Extras.h"
#include "loaders/quirks/TransparencyQuirk.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace {

struct Shader {
    const char* name;
    ShadingModel model;
};
constexpr std::array<Shader, 4> kShaders = {{{"constant", ShadingModel::Constant},
                                             {"lambert", ShadingModel::Lambert},
                                             {"phong", ShadingModel::Phong},
                                             {"blinn", ShadingModel::Blinn}}};

struct SlotName {
    const char* name;
    Slot slot;
};
constexpr std::array<SlotName, 6> kSlots = {{{"emission", Slot::Emission},
                                             {"ambient", Slot::Ambient},
                                             {"diffuse", Slot::Diffuse},
                                             {"specular", Slot::Specular},
                                             {"reflective", Slot::Reflective},
                                             {"transparent", Slot::Transparent}}};

// The colour that replaces a missing picture: white keeps a surface visible, and black keeps it from glowing
// or shining.
glm::vec4 standIn(Slot slot, OpaqueMode opaque) {
    const glm::vec4 white(1.0f), black(0.0f, 0.0f, 0.0f, 1.0f), nothing(0.0f);
    if (slot == Slot::Diffuse || slot == Slot::Ambient) return white;
    if (slot != Slot::Transparent) return black;
    if (opaque == OpaqueMode::RgbZero) return black;
    return opaque == OpaqueMode::AZero ? nothing : white;
}

// Clamped, so that it stays finite.
float toFloat(double number) {
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(number, -kMost, kMost));
}

bool isTrue(XmlNode flag) {
    const std::string text = flag.text();
    return text == "1" || text == "true" || text == "TRUE";
}

bool hasHoles(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 255) return true;
    return false;
}

bool hasDiffusePictures(XmlNode collada) {
    for (XmlNode library : collada.children("library_effects"))
        for (XmlNode effect : library.children("effect"))
            for (XmlNode shader : effect.child("profile_COMMON").child("technique").children())
                if (shader.child("diffuse").child("texture")) return true;
    return false;
}

bool usesAlpha(OpaqueMode opaque) {
    return opaque == OpaqueMode::AOne || opaque == OpaqueMode::AZero;
}

}  // namespace

bool EffectReader::read(XmlNode effect, XmlNode instanceEffect, Material& material) {
    XmlNode profile;
    if (!chooseProfile(effect, profile)) return false;
    const XmlNode technique = profile.child("technique");
    const auto shader = std::find_if(kShaders.begin(), kShaders.end(),
                                     [&](const Shader& known) { return bool(technique.child(known.name)); });
    if (shader == kShaders.end()) {
        context_.diagnostics.report(
            Code::EffectUnusable, technique ? technique : profile,
            {std::string(effect.id()), "has no <constant>, <lambert>, <phong> or <blinn>"});
        return false;
    }
    material.shading = shader->model;
    const XmlNode values = technique.child(shader->name);
    const EffectParameters parameters(effect, profile, technique, instanceEffect, scopes_);
    readOpaque(values.child("transparent"), material);
    for (const SlotName& slot : kSlots) readSlot(values, slot.name, slot.slot, parameters, material);
    readNumber(values, "shininess", parameters, material.shininess);
    readNumber(values, "reflectivity", parameters, material.reflectivity);
    readNumber(values, "transparency", parameters, material.transparency);
    readNumber(values, "index_of_refraction", parameters, material.indexOfRefraction);
    for (const XmlNode element : {values, technique, profile, effect})
        readExtras(element, parameters, material);
    settleTransparency(values, effect, material);
    return true;
}

bool EffectReader::chooseProfile(XmlNode effect, XmlNode& profile) {
    profile = effect.child("profile_COMMON");
    if (profile) return true;
    context_.diagnostics.report(Code::EffectUnusable, effect,
                                {std::string(effect.id()), "has no <profile_COMMON>"});
    return false;
}

void EffectReader::readSlot(XmlNode shader, const char* name, Slot slot, const EffectParameters& parameters,
                            Material& material) {
    const XmlNode node = shader.child(name);
    if (!node) {
        // COLLADA 1.4.1, chapter 7, "Determining transparency": without <transparent>, only <transparency>
        // counts.
        if (slot == Slot::Transparent) material.slot(slot).color = glm::vec4(1.0f);
        if (slot == Slot::Diffuse) useChosenPicture(parameters.effect().root(), material);
        return;
    }
    material.slot(slot).present = true;
    if (!node.child("color") && !node.child("param") && !node.child("texture")) noValue(node, "color");
    if (const XmlNode color = node.child("color")) {
        readColor(color, material.slot(slot).color);
    } else if (const XmlNode param = node.child("param")) {
        if (const XmlNode value = parameter(param, parameters)) readColor(value, material.slot(slot).color);
    } else if (const XmlNode texture = node.child("texture")) {
        readTexture(texture, slot, parameters, material);
    }
    if (slot == Slot::Diffuse && !node.child("texture"))
        useChosenPicture(parameters.effect().root(), material);
}

// Puts the picture of LoadOptions::texture on every material of a document without diffuse pictures. (If
// there are some, it replaces those.)
void EffectReader::useChosenPicture(XmlNode collada, Material& material) {
    if (context_.options.texture.empty()) return;
    const auto [entry, isNew] = hasDiffusePictures_.try_emplace(collada, false);
    if (isNew) entry->second = hasDiffusePictures(collada);
    if (entry->second) return;
    ColorOrTexture& diffuse = material.slot(Slot::Diffuse);
    diffuse.texture = textures_.chosen();
    if (imageOf(material, Slot::Diffuse)) diffuse.color = glm::vec4(1.0f);
}

void EffectReader::readColor(XmlNode value, glm::vec4& color) {
    const std::vector<double> numbers = readDoubles(value, context_.diagnostics, NumberFaults::Warning);
    if (numbers.size() != 3 && numbers.size() != 4)
        context_.diagnostics.report(Code::ColorNumbers, value,
                                    {std::string(value.name()), std::to_string(numbers.size())});
    color = {0.0f, 0.0f, 0.0f, 1.0f};
    for (std::size_t i = 0; i < numbers.size() && i < 4; ++i)
        color[static_cast<int>(i)] = toFloat(numbers[i]);
}

void EffectReader::readNumber(XmlNode shader, const char* name, const EffectParameters& parameters,
                              float& number) {
    const XmlNode node = shader.child(name);
    XmlNode value = node.child("float");
    if (const XmlNode param = node.child("param")) value = parameter(param, parameters);
    if (node && !value && !node.child("param")) noValue(node, "float");
    if (!value) return;
    const std::vector<double> numbers = readDoubles(value, context_.diagnostics, NumberFaults::Warning);
    if (numbers.size() != 1)
        context_.diagnostics.report(
            Code::NumberOddWarning, value,
            {value.text(), std::string(value.name()), numbers.empty() ? "the default" : "the first"});
    if (!numbers.empty()) number = toFloat(numbers.front());
}

// An element of a shader without a value is reported and ignored.
void EffectReader::noValue(XmlNode node, const char* wanted) {
    context_.diagnostics.report(Severity::Warning, Code::MissingElement, node,
                                {std::string(node.name()), wanted});
}

XmlNode EffectReader::parameter(XmlNode param, const EffectParameters& parameters) {
    const XmlNode value = parameters.value(param.attribute("ref"));
    if (!value)
        context_.diagnostics.report(
            Code::ParameterNotThere, param,
            {std::string(param.parent().name()), std::string(parameters.effect().id()),
             std::string(param.attribute("ref"))});
    return value;
}

void EffectReader::readTexture(XmlNode texture, Slot slot, const EffectParameters& parameters,
                               Material& material) {
    ColorOrTexture& target = material.slot(slot);
    target.texture = textures_.read(texture, parameters, slot);
    target.texCoordName = texture.attribute("texcoord");
    target.color = imageOf(material, slot) ? glm::vec4(1.0f) : standIn(slot, material.opaque);
}

const Image* EffectReader::imageOf(const Material& material, Slot slot) const {
    const int texture = material.slot(slot).texture;
    return texture < 0 ? nullptr : model_.textures[static_cast<std::size_t>(texture)].image.get();
}

void EffectReader::readExtras(XmlNode element, const EffectParameters& parameters, Material& material) {
    for (XmlNode technique : extraTechniques(element)) {
        const XmlNode bump = technique.child("bump");
        if (bump && context_.dialects.follows(Quirk::ExtraBump, bump)) readBump(bump, parameters, material);
        if (!isTrue(technique.child("double_sided"))) continue;
        if (!context_.dialects.follows(Quirk::ExtraDoubleSided, technique)) continue;
        material.doubleSided = true;
        context_.dialects.note(Quirk::ExtraDoubleSided, technique);
    }
}

void EffectReader::readBump(XmlNode bump, const EffectParameters& parameters, Material& material) {
    const XmlNode texture = bump.child("texture");
    if (!texture || material.slot(Slot::Bump).present) return;
    material.slot(Slot::Bump).present = true;
    context_.dialects.note(Quirk::ExtraBump, bump);
    readTexture(texture, Slot::Bump, parameters, material);
    const std::string_view kind = bump.attribute("bumptype");
    const Image* image = imageOf(material, Slot::Bump);
    if (!image || image->rgba.empty()) return;
    // Most exporters do not say which kind it is.
    const bool heights = kind.empty() ? holdsHeights(*image) : kind == "HEIGHTFIELD";
    int& index = material.slot(Slot::Bump).texture;
    if (heights) index = textures_.asNormals(index);
}

void EffectReader::readOpaque(XmlNode transparent, Material& material) {
    const std::string_view word = transparent.attribute("opaque");
    if (word == "RGB_ZERO") material.opaque = OpaqueMode::RgbZero;
    if (word == "A_ZERO") material.opaque = OpaqueMode::AZero;
    if (word == "RGB_ONE") material.opaque = OpaqueMode::RgbOne;
    if (!word.empty() && word != "A_ONE" && material.opaque == OpaqueMode::AOne)
        context_.diagnostics.report(
            Code::WordUnknown, transparent,
            {std::string(word), "transparent", didYouMean(word, "A_ONE A_ZERO RGB_ONE RGB_ZERO")});
}

void EffectReader::settleTransparency(XmlNode shader, XmlNode effect, Material& material) {
    if (const XmlNode transparency = shader.child("transparency"))
        correctTransparency(transparency, effect.id(), context_.dialects, context_.diagnostics, material);
    const ColorOrTexture& transparent = material.slot(Slot::Transparent);
    material.transparent = opacity(material, transparent.color) < 1.0f;
    const Image* image = imageOf(material, Slot::Transparent);
    if (!image) return;
    const bool fades = material.transparency < 1.0f;
    material.transparent = !usesAlpha(material.opaque) || fades || hasHoles(*image);
}

}  // namespace walkcycle
