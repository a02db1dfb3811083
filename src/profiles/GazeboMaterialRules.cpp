#include <string>
#include <unordered_set>

#include "profiles/Rules.h"

// Rules from the functions LoadMaterial, LoadColorOrTexture and LoadTransparent of Gazebo's loader. GazeboRules.cpp has
// its address.
namespace walkcycle {
namespace {

// The <effect>s whose materials are transparent by the format's own rules.
std::unordered_set<XmlNode> transparentEffects(const Subject& subject) {
    std::unordered_set<std::string> materials;
    for (const Material& material : subject.model().materials)
        if (material.transparent) materials.insert(material.id);
    std::unordered_set<XmlNode> effects;
    for (const XmlNode material : subject.all("material"))
        if (materials.contains(std::string(material.id())))
            effects.insert(subject.follow(material.child("instance_effect"), "url"));
    return effects;
}

}  // namespace

void checkGazeboMaterials(const Subject& subject) {
    for (const XmlNode constant : subject.all("constant"))
        if (enclosing(constant, "profile_COMMON")) subject.report(Code::GazeboConstant, constant, {});
    for (const XmlNode texture : subject.all("texture"))
        if (isOneOf(texture.parent(), {"ambient", "emission", "specular", "reflective"}))
            subject.report(Code::GazeboTextureSlot, texture, {std::string(texture.parent().name())});
    const std::unordered_set<XmlNode> effects = transparentEffects(subject);
    for (const XmlNode transparent : subject.all("transparent"))
        if (!transparent.has("opaque") && effects.contains(enclosing(transparent, "effect")))
            subject.report(Code::GazeboOpaque, transparent, {});
    for (const XmlNode image : subject.all("image"))
        if (image.child("init_from").text().find('%') != std::string::npos)
            subject.report(Code::GazeboUriEscapes, image.child("init_from"),
                           {image.child("init_from").text()});
}

}  // namespace walkcycle
