#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "animation/JointRows.h"
#include "render/BufferTexture.h"

namespace walkcycle {

// The palettes of all instances in a picture, one after the other, for shaders to read: three rows per joint,
// since the fourth is always 0 0 0 1. There is no limit on joints: if a palette does not fit into the
// driver's texture buffer any more, it starts another page, and meshes whose palette is larger than a page
// are left to CpuSkinning.
class JointPalette {
public:
    struct Place {
        std::size_t page = 0;
        int firstJoint = 0;
    };

    explicit JointPalette(std::size_t maxTexels = BufferTexture::maxTexels());

    std::size_t maxJoints() const { return maxJoints_; }  // the most of one palette
    std::size_t pageCount() const { return pagesInUse_; }

    void clear();  // keeps its memory
    Place add(std::span<const glm::mat4> palette);
    Place add(std::span<const JointRows> palette);
    void upload();
    void bind(std::size_t page, int unit) const;

private:
    struct Page {
        std::vector<JointRows> joints;
        BufferTexture texture{GL_RGBA32F};
    };

    Place newPlace(std::size_t joints);

    std::vector<Page> pages_;
    std::size_t pagesInUse_ = 0;
    std::size_t maxJoints_;
};

}  // namespace walkcycle
