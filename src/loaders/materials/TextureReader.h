#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "loaders/context/LoadContext.h"
#include "loaders/materials/EffectParameters.h"
#include "loaders/materials/PictureFinder.h"
#include "loaders/materials/PicturesAhead.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Reads the <texture>s of effects. A <texture> names a sampler, whose surface names an <image>, which names a
// file (COLLADA 1.4.1, chapter 7). In COLLADA 1.5 the sampler names the <image>; the quirk
// texture-names-image lets the <texture> name it.
class TextureReader {
public:
    TextureReader(const LoadContext& context, Model& model, PicturesAhead* ahead)
        : context_(context), model_(model), pictures_(context, ahead) {}

    // Returns an index into Model::textures, whose picture may be missing; -1, and reported, if there is no
    // <image>.
    int read(XmlNode texture, const EffectParameters& parameters, Slot slot);
    // The texture with the picture of LoadOptions::texture, for materials that have none.
    int chosen();
    // Returns the index of a copy of a texture whose heights are converted to normals, as a bump slot needs
    // them.
    int asNormals(int texture);

private:
    XmlNode imageOf(XmlNode texture, XmlNode sampler, const EffectParameters& parameters);
    XmlNode imageOfSurface(XmlNode surface, XmlNode texture, const EffectParameters& parameters);
    XmlNode imageNamed(XmlNode from, const std::string& name);
    void unresolved(XmlNode texture, const EffectParameters& parameters, const std::string& reason);
    void readSampler(XmlNode sampler, Texture& texture);
    const PictureFinder::Picture& pictureOf(XmlNode image, Texture& texture);

    const LoadContext& context_;
    Model& model_;
    PictureFinder pictures_;
    std::map<int, int> normals_;  // texture of heights -> texture of normals
    std::unordered_map<XmlNode, std::unordered_map<std::string_view, XmlNode>> imagesByName_;  // by <COLLADA>
    // By <image>, sampler, and whether LoadOptions::texture replaces the picture.
    std::map<std::tuple<const void*, const void*, bool>, int> indices_;
};

}  // namespace walkcycle
