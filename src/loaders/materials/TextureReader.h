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

// Follows an effect's <texture> to its picture: sampler, surface, <image>, file. In COLLADA 1.5 the sampler names the
// image itself; the quirk texture-names-image lets the <texture> do so.
class TextureReader {
public:
    TextureReader(const LoadContext& context, Model& model, PicturesAhead* ahead)
        : context_(context), model_(model), pictures_(context, ahead) {}

    // An index into Model::textures (its picture may be missing); -1 where the way ends before an <image>, reported.
    int read(XmlNode texture, const EffectParameters& parameters, Slot slot);
    // The texture that the user chose for what has none.
    int chosen();
    // A texture of heights as one of normals, which is what a bump slot holds. Made once.
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
    std::map<int, int> normals_;
    std::unordered_map<XmlNode, std::unordered_map<std::string_view, XmlNode>> imagesByName_;  // by <COLLADA>
    std::map<std::tuple<const void*, const void*, bool>, int>
        indices_;  // by image, sampler, and whether the user chose
};

}  // namespace walkcycle
