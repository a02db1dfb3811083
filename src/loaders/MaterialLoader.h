#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "loaders/LoadContext.h"
#include "loaders/PicturesAhead.h"
#include "model/Model.h"

namespace walkcycle {

// Reads materials as instances bind them: each <material> once (cached), its <effect>, samplers, surfaces and pictures.
class MaterialLoader {
public:
    // `ahead` may hold pictures that are decoded already; null: none are.
    MaterialLoader(const LoadContext& context, Model& model, PicturesAhead* ahead = nullptr);
    ~MaterialLoader();

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
