#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/BufferTexture.h"
#include "walkcycle/animation/JointRows.h"

namespace walkcycle {

// The palettes of all instances in a picture, one after the other, for shaders to read: three rows per joint,
// since the fourth is always 0 0 0 1. A palette is computed in the memory that is uploaded. There is no limit on
// joints: if a palette does not fit into the driver's texture buffer any more, it starts another page, and meshes
// whose palette is larger than a page are left to CpuSkinning.
class JointPalette {
public:
    // A palette's place among all of them.
    struct Range {
        std::size_t page = 0, firstJoint = 0, jointCount = 0;
    };

    explicit JointPalette(std::size_t maxTexels = BufferTexture::maxTexels());

    std::size_t maxJoints() const { return maxJoints_; }  // the most of one palette
    std::size_t pageCount() const { return pagesInUse_; }

    void clear();  // keeps its memory
    Range add(std::size_t joints);

    // Where a palette is written to and read from; until the next add().
    std::span<JointRows> joints(const Range& range);
    std::span<const JointRows> joints(const Range& range) const;

    void upload();
    void bind(std::size_t page, int unit) const;

private:
    struct Page {
        std::vector<JointRows> joints;  // as many as there ever were: only the first `used` count
        std::size_t used = 0;
        BufferTexture texture{GL_RGBA32F};
    };

    std::vector<Page> pages_;
    std::size_t pagesInUse_ = 0;
    std::size_t maxJoints_;
};

}  // namespace walkcycle
