#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/DocumentSet.h"
#include "loaders/materials/MaterialLoader.h"
#include "loaders/quirks/Dialect.h"

namespace walkcycle {

// A document and what its materials are read with.
struct MaterialsOf {
    explicit MaterialsOf(const std::string& path, LoadOptions loadOptions = {})
        : options(std::move(loadOptions)), root(documents.openFile(path).root()) {}

    static std::string fixture(const std::string& name) { return WALKCYCLE_FIXTURES "/" + name; }

    // A triangle that asks for a material of that symbol.
    static MeshData meshAsking(const std::string& symbol) {
        MeshData mesh;
        mesh.id = "mesh";
        mesh.parts.resize(1);
        mesh.parts[0].materialSymbol = symbol;
        mesh.texCoordSets = {{0, {}}, {1, {}}};
        return mesh;
    }

    // The material of that id, as a part that asks for it by name gets it; a default one where it is not to be had.
    Material material(const std::string& id) {
        const PartMaterial bound = loader.bind(root.child("library_materials"), meshAsking(id)).at(0);
        return bound.material < 0 ? Material{} : model.materials.at(static_cast<std::size_t>(bound.material));
    }

    const Texture& texture(const Material& material, Slot slot) {
        return model.textures.at(static_cast<std::size_t>(material.slot(slot).texture));
    }

    // What a node's instance binds to the symbol "symbol".
    PartMaterial boundAt(const std::string& node) {
        const XmlNode instance = root.elementById(node).child("instance_geometry");
        return loader.bind(instance, meshAsking("symbol")).at(0);
    }

    int count(Code code, Severity severity) const {
        return static_cast<int>(std::count_if(
            diagnostics.all().begin(), diagnostics.all().end(),
            [&](const Diagnostic& said) { return said.code == info(code).id && said.severity == severity; }));
    }
    int warnings(Code code) const { return count(code, Severity::Warning); }
    int notes(Code code) const { return count(code, Severity::Info); }
    bool hasErrors() const {
        return std::any_of(diagnostics.all().begin(), diagnostics.all().end(),
                           [](const Diagnostic& said) { return said.severity == Severity::Error; });
    }

    LoadOptions options;
    Diagnostics diagnostics;
    DocumentSet documents{options, diagnostics};
    Dialects dialects{options, diagnostics};
    SourceReader sources{documents, diagnostics, dialects};
    LoadContext context{options, diagnostics, documents, sources, dialects};
    Model model;
    MaterialLoader loader{context, model};
    XmlNode root;
};

}  // namespace walkcycle
