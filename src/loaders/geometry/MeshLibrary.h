#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/document/XmlNode.h"
#include "loaders/geometry/LoadedMesh.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The geometries of a load, each read once however often it is instanced or morphed to.
class MeshLibrary {
public:
    MeshLibrary(const LoadContext& context, const Asset& asset, XmlNode rootCollada)
        : context_(context), asset_(asset), rootCollada_(rootCollada) {}

    const LoadedMesh& load(XmlNode geometry);

    // To be told of each mesh that something deforms: where the file has no normals, those of the new shape are made.
    void willDeform(XmlNode geometry);

    // Meshes, and what is made for each of their positions, cost memory that one source shared by many can multiply.
    void countPositions(std::size_t count, XmlNode where);

    // Its index in Model::meshes, where moveInto puts it: the meshes that are drawn, not those only morphed to.
    int drawn(XmlNode geometry);
    void moveInto(Model& model);

private:
    const LoadContext& context_;
    const Asset& asset_;
    XmlNode rootCollada_;
    std::unordered_map<XmlNode, std::unique_ptr<LoadedMesh>> meshes_;
    std::unordered_map<XmlNode, int> indices_;
    std::vector<LoadedMesh*> drawn_;
    std::uint64_t positions_ = 0;
};

}  // namespace walkcycle
