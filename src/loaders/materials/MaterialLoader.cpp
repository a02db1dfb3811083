#include "loaders/materials/MaterialLoader.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "loaders/materials/EffectReader.h"
#include "loaders/materials/PicturesAhead.h"
#include "loaders/materials/Tangents.h"
#include "loaders/materials/TexCoordBinding.h"
#include "loaders/quirks/Dialect.h"

namespace walkcycle {
namespace {

using NodesByName = std::unordered_map<std::string_view, XmlNode>;

// The <instance_material>s of an instance by symbol. (Some hand-written files leave out <technique_common>.)
NodesByName bindingsOf(XmlNode instance) {
    const XmlNode bindMaterial = instance.child("bind_material");
    const XmlNode common = bindMaterial.child("technique_common");
    NodesByName bindings;
    for (XmlNode binding : (common ? common : bindMaterial).children("instance_material"))
        bindings.try_emplace(binding.attribute("symbol"), binding);
    return bindings;
}

}  // namespace

struct MaterialLoader::Impl {
    Impl(const LoadContext& loadContext, Model& loaded)
        : context(loadContext), model(loaded), effects(loadContext, loaded, &pictures) {}

    const LoadContext& context;
    Model& model;
    PicturesAhead pictures;
    EffectReader effects;
    std::unordered_map<XmlNode, std::optional<Material>> effectsRead;  // empty: cannot be shown
    std::unordered_map<XmlNode, int> materials;  // <material> -> Model::materials; -1: cannot be shown
    std::unordered_map<XmlNode, NodesByName> materialsByName;  // by <COLLADA>
    std::unordered_multimap<XmlNode, int> elements;

    int load(XmlNode material);
    int read(XmlNode material);
    int bound(XmlNode binding);
    int guess(XmlNode instance, const MeshPart& part, const MeshData& mesh);
    XmlNode named(XmlNode collada, std::string_view symbol);
};

int MaterialLoader::Impl::load(XmlNode material) {
    const auto [entry, isNew] = materials.try_emplace(material, -1);
    if (isNew) entry->second = read(material);
    return entry->second;
}

int MaterialLoader::Impl::read(XmlNode material) {
    const XmlNode instance = material.child("instance_effect");
    const XmlNode effect = context.documents.resolve(instance, instance.attribute("url"), Severity::Warning);
    if (!effect.is("effect")) {
        context.diagnostics.report(Code::EffectNotThere, instance ? instance : material,
                                   {std::string(material.id()), std::string(instance.attribute("url"))});
        return -1;
    }
    // Materials without <setparam> share the result of reading their effect.
    const bool isOwn = static_cast<bool>(instance.child("setparam"));
    const auto [known, isNew] = effectsRead.try_emplace(isOwn ? XmlNode() : effect);
    if (isNew || isOwn) {
        known->second = Material();
        if (!effects.read(effect, instance, *(known->second))) known->second.reset();
    }
    if (!known->second) return -1;
    Material result = *known->second;
    result.id = material.id();
    result.name = material.attribute("name");
    const int index = static_cast<int>(model.materials.size());
    elements.emplace(material, index);
    elements.emplace(effect, index);
    model.materials.push_back(std::move(result));
    return index;
}

int MaterialLoader::Impl::bound(XmlNode binding) {
    const std::string target(binding.attribute("target"));
    const XmlNode material = context.documents.resolve(binding, target, Severity::Warning);
    if (material.is("material")) return load(material);
    context.diagnostics.report(Code::MaterialNotThere, binding,
                               {std::string(binding.attribute("symbol")), target});
    return -1;
}

XmlNode MaterialLoader::Impl::named(XmlNode collada, std::string_view symbol) {
    if (const XmlNode material = collada.elementById(symbol); material.is("material")) return material;
    const auto [entry, isNew] = materialsByName.try_emplace(collada);
    if (isNew)
        for (XmlNode library : collada.children("library_materials"))
            for (XmlNode known : library.children("material"))
                entry->second.try_emplace(known.attribute("name"), known);
    const auto found = entry->second.find(symbol);
    return found == entry->second.end() ? XmlNode() : found->second;
}

// The material of a part that <bind_material> does not map; -1 if there is none. A part without a symbol has
// none.
int MaterialLoader::Impl::guess(XmlNode instance, const MeshPart& part, const MeshData& mesh) {
    if (part.materialSymbol.empty()) return -1;
    const bool follows = context.dialects.follows(Quirk::MaterialBySymbol, instance);
    const XmlNode material = follows ? named(instance.root(), part.materialSymbol) : XmlNode();
    if (!material) {
        context.diagnostics.report(Code::MaterialUnbound, instance, {part.materialSymbol, mesh.id});
        return -1;
    }
    context.diagnostics.report(Code::MaterialGuessed, instance, {part.materialSymbol, mesh.id});
    context.dialects.note(Quirk::MaterialBySymbol, instance);
    return load(material);
}

MaterialLoader::MaterialLoader(const LoadContext& context, Model& model)
    : impl_(std::make_unique<Impl>(context, model)) {}
MaterialLoader::~MaterialLoader() = default;

void MaterialLoader::decodeAhead(XmlNode collada) {
    impl_->pictures.begin(collada, impl_->context.documents, impl_->context.options);
}

std::vector<PartMaterial> MaterialLoader::bind(XmlNode instance, const MeshData& mesh) {
    const NodesByName bindings = bindingsOf(instance);
    std::vector<PartMaterial> result;
    result.reserve(mesh.parts.size());
    for (const MeshPart& part : mesh.parts) {
        const auto found = bindings.find(part.materialSymbol);
        const XmlNode binding = found == bindings.end() ? XmlNode() : found->second;
        PartMaterial bound;
        bound.material = binding ? impl_->bound(binding) : impl_->guess(instance, part, mesh);
        bound.texCoordSets.fill(-1);
        if (bound.material >= 0) {
            const Material& material = impl_->model.materials[static_cast<std::size_t>(bound.material)];
            bindTexCoords(material, binding ? binding : instance, mesh, part, impl_->context, bound);
        }
        result.push_back(bound);
    }
    return result;
}

const std::unordered_multimap<XmlNode, int>& MaterialLoader::elements() const {
    return impl_->elements;
}

void makeBumpTangents(Model& model) {
    constexpr auto kBump = static_cast<std::size_t>(Slot::Bump);
    for (const MeshInstance& instance : model.instances) {
        MeshData& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const PartMaterial& bound : instance.materials) {
            const int set = bound.texCoordSets[kBump];
            if (bound.material >= 0 && set >= 0 && mesh.tangents.empty())
                makeTangents(mesh, static_cast<std::size_t>(set));
        }
    }
}

}  // namespace walkcycle
