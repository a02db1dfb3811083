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

// The geometries of one load. Each is read once, even if several instances or morphs use it.
class MeshLibrary {
public:
    MeshLibrary(const LoadContext& context, const Asset& asset, XmlNode rootCollada)
        : context_(context), asset_(asset), rootCollada_(rootCollada) {}

    // Reads a <geometry> on the first call, in the unit and up axis of the root document's <asset>.
    const LoadedMesh& load(XmlNode geometry);

    // Prepares a mesh for deformers: if the file has no normals for it, fills MeshData::madeNormals, so that
    // they can be computed for each deformed shape. Call it for each mesh that a controller deforms.
    void willDeform(XmlNode geometry);

    // Counts positions against LoadLimits::maxPositions, and throws LoadError when there are too many. Skins
    // and morph targets count, too: they hold data for each position of their mesh, and a small file can name
    // one mesh many times.
    void countPositions(std::size_t count, XmlNode where);

    // The geometry's index in Model::meshes after moveInto(). Only meshes that are drawn get one, not those
    // that are only morph targets.
    int drawn(XmlNode geometry);
    void moveInto(Model& model);  // leaves the drawn meshes empty here

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
