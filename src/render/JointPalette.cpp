#include "render/JointPalette.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace walkcycle {
namespace {

constexpr std::size_t kRowsPerJoint = 3;

}  // namespace

JointPalette::JointPalette(std::size_t maxTexels) : maxJoints_(maxTexels / kRowsPerJoint) {}

void JointPalette::clear() {
    for (Page& page : pages_) page.used = 0;
    pagesInUse_ = 0;
}

JointPalette::Range JointPalette::add(std::size_t joints) {
    assert(joints <= maxJoints_);
    if (pagesInUse_ == 0 || pages_[pagesInUse_ - 1].used + joints > maxJoints_) {
        if (++pagesInUse_ > pages_.size()) pages_.emplace_back();
    }
    Page& page = pages_[pagesInUse_ - 1];
    const Range range{pagesInUse_ - 1, page.used, joints};
    page.used += joints;
    if (page.joints.size() < page.used) page.joints.resize(page.used);
    return range;
}

std::span<JointRows> JointPalette::joints(const Range& range) {
    return std::span(pages_[range.page].joints).subspan(range.firstJoint, range.jointCount);
}

std::span<const JointRows> JointPalette::joints(const Range& range) const {
    return std::span(pages_[range.page].joints).subspan(range.firstJoint, range.jointCount);
}

void JointPalette::upload() {
    for (std::size_t i = 0; i < pagesInUse_; ++i) {
        Page& page = pages_[i];
        page.texture.store(std::span<const JointRows>(page.joints).first(page.used), GL_STREAM_DRAW);
    }
}

void JointPalette::bind(std::size_t page, int unit) const {
    pages_[page].texture.bind(unit);
}

}  // namespace walkcycle
