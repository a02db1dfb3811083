#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Reads materials as instances bind them: each <material> once (cached), its <effect>, samplers, surfaces and pictures.
class MaterialLoader {
public:
    MaterialLoader(const LoadContext& context, Model& model);
    ~MaterialLoader();

    // Begins to decode the pictures that the document's <image>s name, on other threads, while other things are read.
    void decodeAhead(XmlNode collada);

    // One PartMaterial per part of the mesh, from the <bind_material> of an <instance_geometry> or
    // <instance_controller> (which may be missing: parts then look for a material whose id or name is their symbol).
    std::vector<PartMaterial> bind(XmlNode instance, const MeshData& mesh);

    // <effect> and <material> elements -> Model::materials, for animation channels.
    const std::unordered_multimap<XmlNode, int>& elements() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Bump pictures lean along a surface's tangents: makes those of every mesh that has such a picture bound.
void makeBumpTangents(Model& model);

}  // namespace walkcycle
