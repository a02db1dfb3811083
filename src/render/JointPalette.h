#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "animation/JointRows.h"
#include "render/BufferTexture.h"

namespace walkcycle {

// The palettes of everything in a picture, one after the other, for shaders to read: three rows a joint, as
// the fourth is always 0 0 0 1. No limit on joints comes from here: where a driver's texture buffers are
// full, the next palette starts another page, and one that is too large for a page is left to CpuSkinning.
class JointPalette {
public:
    struct Place {
        std::size_t page = 0;
        int firstJoint = 0;
    };

    explicit JointPalette(std::size_t maxTexels = BufferTexture::maxTexels());

    std::size_t maxJoints() const { return maxJoints_; }  // of one palette
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
