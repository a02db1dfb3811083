#pragma once

#include <string_view>
#include <unordered_map>

#include "loaders/context/LoadContext.h"
#include "loaders/materials/EffectParameters.h"
#include "loaders/materials/PicturesAhead.h"
#include "loaders/materials/TextureReader.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Reads the <profile_COMMON> of an <effect> (COLLADA 1.4.1, chapter 8), with the parameters that a material's
// <instance_effect> sets.
class EffectReader {
public:
    EffectReader(const LoadContext& context, Model& model, PicturesAhead* ahead)
        : context_(context), model_(model), textures_(context, model, ahead) {}

    // Fills `material`. Returns false, and reports it, if the effect has nothing that can be shown.
    bool read(XmlNode effect, XmlNode instanceEffect, Material& material);

private:
    bool chooseProfile(XmlNode effect, XmlNode& profile);
    void readSlot(XmlNode shader, const char* name, Slot slot, const EffectParameters& parameters,
                  Material& material);
    void readColor(XmlNode value, glm::vec4& color);
    void readNumber(XmlNode shader, const char* name, const EffectParameters& parameters, float& number);
    void noValue(XmlNode node, const char* wanted);
    XmlNode parameter(XmlNode param, const EffectParameters& parameters);
    void readTexture(XmlNode texture, Slot slot, const EffectParameters& parameters, Material& material);
    void useChosenPicture(XmlNode collada, Material& material);
    void readExtras(XmlNode element, const EffectParameters& parameters, Material& material);
    void readBump(XmlNode bump, const EffectParameters& parameters, Material& material);
    void readOpaque(XmlNode transparent, Material& material);
    void settleTransparency(XmlNode shader, XmlNode effect, Material& material);
    const Image* imageOf(const Material& material, Slot slot) const;

    const LoadContext& context_;
    Model& model_;
    TextureReader textures_;
    ParameterScopes scopes_;
    std::unordered_map<XmlNode, bool> hasDiffusePictures_;
};

}  // namespace walkcycle
