#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Reads the materials that instances bind: each <material> once, with its <effect>, samplers, surfaces and
// pictures.
class MaterialLoader {
public:
    MaterialLoader(const LoadContext& context, Model& model);
    ~MaterialLoader();

    // Begins to decode the pictures of the <image>s of a document on other threads, while other elements are
    // read.
    void decodeAhead(XmlNode collada);

    // Returns one PartMaterial per part of the mesh. `instance` is an <instance_geometry> or
    // <instance_controller>, whose <bind_material> maps the symbols of the parts to materials. A symbol that
    // it does not map is reported; the quirk material-by-symbol then takes the material with that id or name.
    std::vector<PartMaterial> bind(XmlNode instance, const MeshData& mesh);

    // The <effect> and <material> elements of each entry of Model::materials, for animation channels.
    const std::unordered_multimap<XmlNode, int>& elements() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Computes the tangents of every mesh with a bump texture, whose normals are relative to them.
void makeBumpTangents(Model& model);

}  // namespace walkcycle
