#include <algorithm>

#include "loaders/ChannelTarget.h"
#include "profiles/Rules.h"

// LoadMaterial, LoadColorOrTexture and LoadTransparent of Gazebo's loader: see GazeboRules.cpp.
namespace walkcycle {
namespace {

// Whether a material of that <effect> is see-through, as the format means it.
bool isTransparent(const Subject& subject, XmlNode effect) {
    for (const XmlNode material : subject.all("material")) {
        if (!(subject.follow(material.child("instance_effect"), "url") == effect)) continue;
        for (const Material& loaded : subject.model().materials)
            if (loaded.id == material.id() && loaded.transparent) return true;
    }
    return false;
}

}  // namespace

void checkGazeboMaterials(const Subject& subject) {
    for (const XmlNode constant : subject.all("constant"))
        if (enclosing(constant, "profile_COMMON")) subject.report(Code::GazeboConstant, constant, {});
    for (const XmlNode texture : subject.all("texture"))
        if (isOneOf(texture.parent(), {"ambient", "emission", "specular", "reflective"}))
            subject.report(Code::GazeboTextureSlot, texture, {std::string(texture.parent().name())});
    for (const XmlNode transparent : subject.all("transparent"))
        if (!transparent.has("opaque") && isTransparent(subject, enclosing(transparent, "effect")))
            subject.report(Code::GazeboOpaque, transparent, {});
    for (const XmlNode image : subject.all("image"))
        if (image.child("init_from").text().find('%') != std::string::npos)
            subject.report(Code::GazeboUriEscapes, image.child("init_from"),
                           {image.child("init_from").text()});
}

}  // namespace walkcycle
