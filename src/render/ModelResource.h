#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "render/GlTexture.h"
#include "render/MeshBuffers.h"
#include "render/ScreenArea.h"
#include "walkcycle/model/Bounds.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The features that a shader must have to draw a model: the union over all its materials and meshes, so that one shader
// draws the whole model. Other features are not compiled.
struct ShaderNeeds {
    std::uint32_t texturedSlots = 0;  // a bit per Slot that has a picture
    bool separateCoords = false;      // slots of one part use different texture coordinates
    bool bumped = false;              // a bump map
    bool vertexColors = false;
    bool seeThrough = false;  // a part is transparent, or can become so
    bool morphs = false;
    bool moreInfluences = false;  // a vertex has more than four

    auto operator<=>(const ShaderNeeds&) const = default;
};

// A model's buffers and textures on the GPU, shared by every AnimatedModel of it. Belongs to the OpenGL context that
// was current when it was made.
class ModelResource {
public:
    // A part of an instance, which one OpenGL call draws.
    struct Part {
        Primitive primitive = Primitive::Triangles;
        std::uint32_t firstIndex = 0, indexCount = 0;
        int material = -1;         // index into Model::materials
        std::size_t vao = 0;       // the argument of vao()
        std::uint32_t middle = 0;  // the position nearest to the part's middle (an index), for sorting
    };

    // The same index as in Model::instances.
    struct Instance {
        bool deformedOnCpu = false;
        int skin = -1;        // index into Model::skins; -1: no skin, or deformed on the CPU
        int influences = -1;  // index into Model::influences, for the skin
        const InfluenceBuffers* influenceBuffers = nullptr;
        const MorphBuffers* morphBuffers = nullptr;
        std::size_t morphCount = 0;                 // leading morphs, which the shader applies
        std::unique_ptr<DeformedBuffers> deformed;  // set if deformedOnCpu
        std::vector<Part> parts;
        std::vector<Bounds> boxes;  // boxesOfMatrices(); empty if they do not enclose the deformed mesh
    };

    // `maxTexels`: the size of the largest texture buffer. Instances that need a larger one are deformed on the CPU.
    explicit ModelResource(const Model& model, std::size_t maxTexels = BufferTexture::maxTexels());

    const std::vector<Instance>& instances() const { return instances_; }
    const Vao& vao(std::size_t i) const { return vaos_[i]; }

    // The picture of Model::textures[index], as colours or (for the bump slot) as data. Null if there is none.
    const GlTexture* texture(int index, Slot slot) const;
    const GlTexture& white() const { return white_; }  // for slots without a picture

    const ShaderNeeds& needs() const { return needs_; }

private:
    using VaoKey = std::array<int, 4 + kSlotCount>;  // of all buffers that feed a vertex array

    void addTextures(const Model& model);
    void addTexture(const Model& model, int index, Slot slot);
    void addInstance(const Model& model, const MeshInstance& instance, std::size_t maxTexels);
    Part part(const Model& model, const MeshInstance& instance, std::size_t index, const Instance& resource);
    std::size_t vaoFor(const Model& model, const MeshInstance& instance, const PartMaterial& material,
                       const Instance& resource);
    const MeshBuffers& meshBuffers(const Model& model, int mesh);
    const InfluenceBuffers& influenceBuffers(const Model& model, int influences, int mesh);
    const MorphBuffers& morphBuffers(const Model& model, const MeshInstance& instance, std::size_t count);

    std::vector<Instance> instances_;
    std::map<int, MeshBuffers> meshes_;
    std::map<std::array<int, 2>, InfluenceBuffers> influences_;
    std::map<std::vector<int>, MorphBuffers> morphs_;
    std::map<VaoKey, std::size_t> vaoOfKey_;
    std::vector<Vao> vaos_;
    std::vector<std::optional<GlTexture>> colorTextures_, dataTextures_;
    GlTexture white_ = GlTexture::white();
    ShaderNeeds needs_;
};

}  // namespace walkcycle
