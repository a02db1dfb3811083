#include "loaders/materials/TextureReader.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "loaders/materials/BumpMap.h"
#include "loaders/quirks/Dialect.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace {

template <typename Value>
struct Word {
    std::string_view text;
    Value value;
};

constexpr std::array<Word<Wrap>, 5> kWraps = {{{"WRAP", Wrap::Repeat},
                                               {"MIRROR", Wrap::Mirror},
                                               {"CLAMP", Wrap::Clamp},
                                               {"BORDER", Wrap::Border},
                                               {"NONE", Wrap::Transparent}}};

// NONE means that the program may choose, so it has the default filter.
constexpr std::array<Word<Filter>, 8> kFilters = {{{"NONE", Filter::LinearMipmapLinear},
                                                   {"NEAREST", Filter::Nearest},
                                                   {"LINEAR", Filter::Linear},
                                                   {"NEAREST_MIPMAP_NEAREST", Filter::NearestMipmapNearest},
                                                   {"LINEAR_MIPMAP_NEAREST", Filter::LinearMipmapNearest},
                                                   {"NEAREST_MIPMAP_LINEAR", Filter::NearestMipmapLinear},
                                                   {"LINEAR_MIPMAP_LINEAR", Filter::LinearMipmapLinear},
                                                   {"ANISOTROPIC", Filter::LinearMipmapLinear}}};

template <typename Value, std::size_t N>
void readWord(XmlNode node, const std::array<Word<Value>, N>& words, Value& value, Diagnostics& diagnostics) {
    if (!node) return;
    const std::string text = node.text();
    std::string known;
    for (const Word<Value>& word : words) {
        known.append(word.text).append(" ");
        if (word.text != text) continue;
        value = word.value;
        return;
    }
    diagnostics.report(Code::WordUnknown, node, {text, std::string(node.name()), didYouMean(text, known)});
}

// COLLADA 1.5 has an element of its own for the filter between mipmaps.
Filter withMipmaps(Filter filter, std::string_view mipFilter) {
    if (mipFilter == "LINEAR")
        return filter == Filter::Nearest ? Filter::NearestMipmapLinear : Filter::LinearMipmapLinear;
    if (mipFilter == "NEAREST")
        return filter == Filter::Nearest ? Filter::NearestMipmapNearest : Filter::LinearMipmapNearest;
    return filter;
}

// The <init_from> of the picture itself. Those of its mipmaps and other slices have attributes.
XmlNode mainInitFrom(XmlNode surface) {
    const auto isFirst = [](XmlNode node, const char* attribute) {
        return !node.has(attribute) || node.attribute(attribute) == "0";
    };
    for (XmlNode node : surface.children("init_from"))
        if (isFirst(node, "mip") && isFirst(node, "slice")) return node;
    return surface.child("init_from");
}

// The <init_from> of an <image>. COLLADA 1.5 may put it into another element.
XmlNode initOf(XmlNode image) {
    if (const XmlNode init = image.child("init_from")) return init;
    for (const char* create : {"create_2d", "create_3d", "create_cube"})
        if (const XmlNode init = image.child(create).child("init_from")) return init;
    return {};
}

}  // namespace

int TextureReader::read(XmlNode texture, const EffectParameters& parameters, Slot slot) {
    XmlNode sampler = parameters.value(texture.attribute("texture"));
    const XmlNode image = imageOf(texture, sampler, parameters);
    const bool chosen = slot == Slot::Diffuse && !context_.options.texture.empty();
    if (!image && !chosen) return -1;
    const auto [entry, isNew] = indices_.try_emplace({image.element(), sampler.element(), chosen},
                                                     static_cast<int>(model_.textures.size()));
    if (!isNew) return entry->second;
    Texture result;
    result.id = image.id();
    readSampler(sampler, result);
    const PictureFinder::Picture& picture = chosen ? pictures_.chosenByUser() : pictureOf(image, result);
    result.path = picture.path;
    result.image = picture.image;
    model_.textures.push_back(std::move(result));
    return entry->second;
}

int TextureReader::chosen() {
    const auto [entry, isNew] =
        indices_.try_emplace({nullptr, nullptr, true}, static_cast<int>(model_.textures.size()));
    if (!isNew) return entry->second;
    const PictureFinder::Picture& picture = pictures_.chosenByUser();
    Texture result;
    result.path = picture.path;
    result.image = picture.image;
    model_.textures.push_back(std::move(result));
    return entry->second;
}

int TextureReader::asNormals(int texture) {
    const auto [entry, isNew] = normals_.try_emplace(texture, static_cast<int>(model_.textures.size()));
    if (!isNew) return entry->second;
    Texture result = model_.textures[static_cast<std::size_t>(texture)];
    assert(result.image);
    result.image = std::make_shared<const Image>(normalsOfHeights(*result.image));
    model_.textures.push_back(std::move(result));
    return entry->second;
}

XmlNode TextureReader::imageOf(XmlNode texture, XmlNode sampler, const EffectParameters& parameters) {
    const std::string name(texture.attribute("texture"));
    if (name.empty()) {
        unresolved(texture, parameters, "it names no sampler");
        return {};
    }
    if (!sampler) {
        const bool follows = context_.dialects.follows(Quirk::TextureNamesImage, texture);
        const XmlNode image = follows ? imageNamed(texture, name) : XmlNode();
        if (!image) {
            unresolved(texture, parameters, "there is no sampler of that name");
            return {};
        }
        context_.diagnostics.report(Code::TextureNamesImage, texture, {name});
        context_.dialects.note(Quirk::TextureNamesImage, texture);
        return image;
    }
    if (sampler.is("surface")) return imageOfSurface(sampler, texture, parameters);
    if (const XmlNode instance = sampler.child("instance_image")) {  // COLLADA 1.5
        const XmlNode image =
            context_.documents.resolve(instance, instance.attribute("url"), Severity::Warning);
        if (image.is("image")) return image;
        unresolved(texture, parameters, "there is no image '" + std::string(instance.attribute("url")) + "'");
        return {};
    }
    const std::string source = sampler.child("source").text();
    if (const XmlNode surface = parameters.value(source)) return imageOfSurface(surface, texture, parameters);
    const XmlNode image = imageNamed(texture, source);
    if (!image) unresolved(texture, parameters, "its sampler's surface '" + source + "' is not there");
    return image;
}

XmlNode TextureReader::imageOfSurface(XmlNode surface, XmlNode texture, const EffectParameters& parameters) {
    std::string name = mainInitFrom(surface).text();
    for (const char* init : {"init_planar", "init_cube", "init_volume"})
        if (name.empty()) name = surface.child(init).child("all").attribute("ref");
    const XmlNode image = imageNamed(surface, name);
    if (image) return image;
    unresolved(texture, parameters,
               name.empty() ? "its surface names no image" : "there is no image '" + name + "'");
    return {};
}

// The <image> with this id ("#id" is accepted) or name (as some files by hand have it). It is searched in the
// same document only, because an IDREF cannot name another.
XmlNode TextureReader::imageNamed(XmlNode from, const std::string& name) {
    if (name.empty()) return {};
    const XmlNode collada = from.root();
    if (const XmlNode image = collada.elementById(name.front() == '#' ? name.substr(1) : name);
        image.is("image"))
        return image;
    const auto [entry, isNew] = imagesByName_.try_emplace(collada);
    if (isNew)
        for (XmlNode library : collada.children("library_images"))
            for (XmlNode image : library.children("image"))
                entry->second.try_emplace(image.attribute("name"), image);
    const auto found = entry->second.find(name);
    return found == entry->second.end() ? XmlNode() : found->second;
}

void TextureReader::unresolved(XmlNode texture, const EffectParameters& parameters,
                               const std::string& reason) {
    context_.diagnostics.report(
        Code::TextureUnresolved, texture,
        {std::string(texture.attribute("texture")), std::string(parameters.effect().id()), reason});
}

void TextureReader::readSampler(XmlNode sampler, Texture& texture) {
    Diagnostics& diagnostics = context_.diagnostics;
    readWord(sampler.child("wrap_s"), kWraps, texture.wrapS, diagnostics);
    readWord(sampler.child("wrap_t"), kWraps, texture.wrapT, diagnostics);
    readWord(sampler.child("minfilter"), kFilters, texture.minFilter, diagnostics);
    readWord(sampler.child("magfilter"), kFilters, texture.magFilter, diagnostics);
    texture.minFilter = withMipmaps(texture.minFilter, sampler.child("mipfilter").text());
    // Mipmaps are not used for enlarging.
    texture.magFilter = texture.magFilter == Filter::Nearest ? Filter::Nearest : Filter::Linear;
    if (const XmlNode border = sampler.child("border_color")) {
        const std::vector<double> numbers = readDoubles(border, diagnostics, NumberFaults::Warning);
        for (std::size_t i = 0; i < numbers.size() && i < 4; ++i)
            texture.borderColor[static_cast<int>(i)] = static_cast<float>(numbers[i]);
    }
}

const PictureFinder::Picture& TextureReader::pictureOf(XmlNode image, Texture& texture) {
    static const PictureFinder::Picture kNone;
    const XmlNode init = initOf(image);
    if (const XmlNode data = image.child("data")) return pictures_.embedded(data);
    if (const XmlNode hex = init.child("hex")) return pictures_.embedded(hex);
    const XmlNode ref = init.child("ref");  // COLLADA 1.5
    texture.uri = ref ? ref.text() : init.text();
    if (!texture.uri.empty()) return pictures_.find(ref ? ref : init, texture.uri);
    context_.diagnostics.report(Code::ImageEmpty, init ? init : image, {std::string(image.id())});
    return kNone;
}

}  // namespace walkcycle
