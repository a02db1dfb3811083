#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/BufferTexture.h"
#include "walkcycle/animation/JointRows.h"

namespace walkcycle {

// The palettes of all instances in a picture, one after the other, in texture buffers (pages) that the shader reads:
// three rows per joint, since the fourth is always 0 0 0 1. A palette is written into the memory that is uploaded.
// There is no limit on joints: if a palette does not fit into the rest of a page, it starts the next page.
// ModelResource leaves a mesh whose palette is larger than a page to CpuSkinning.
class JointPalette {
public:
    // The location of a palette.
    struct Range {
        std::size_t page = 0, firstJoint = 0, jointCount = 0;
    };

    // `maxTexels`: the size of a page, three texels per joint.
    explicit JointPalette(std::size_t maxTexels = BufferTexture::maxTexels());

    std::size_t pageCount() const { return pagesInUse_; }

    void clear();  // forgets all palettes, but keeps the memory

    // Reserves a palette of so many joints, at most a page.
    Range add(std::size_t joints);

    // The matrices of a palette, to write and to read. Valid until the next add().
    std::span<JointRows> joints(const Range& range);
    std::span<const JointRows> joints(const Range& range) const;

    void upload();  // copies all palettes to the GPU
    void bind(std::size_t page, int unit) const;

private:
    struct Page {
        std::vector<JointRows> joints;  // only the first `used` are of this picture
        std::size_t used = 0;
        BufferTexture texture{GL_RGBA32F};
    };

    std::vector<Page> pages_;
    std::size_t pagesInUse_ = 0;
    std::size_t maxJoints_;
};

}  // namespace walkcycle
