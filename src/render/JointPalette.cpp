#include "render/JointPalette.h"

#include <cassert>

namespace walkcycle {
namespace {

constexpr std::size_t kRowsPerJoint = 3;

}  // namespace

JointPalette::JointPalette(std::size_t maxTexels) : maxJoints_(maxTexels / kRowsPerJoint) {}

void JointPalette::clear() {
    for (Page& page : pages_) page.joints.clear();
    pagesInUse_ = 0;
}

JointPalette::Place JointPalette::newPlace(std::size_t joints) {
    assert(joints <= maxJoints_);
    const auto there = [&] { return pages_[pagesInUse_ - 1].joints.size(); };
    if (pagesInUse_ == 0 || there() + joints > maxJoints_) {
        if (++pagesInUse_ > pages_.size()) pages_.emplace_back();
    }
    return {pagesInUse_ - 1, static_cast<int>(there())};
}

JointPalette::Place JointPalette::add(std::span<const glm::mat4> palette) {
    const Place place = newPlace(palette.size());
    for (const glm::mat4& matrix : palette) pages_[place.page].joints.emplace_back(matrix);
    return place;
}

JointPalette::Place JointPalette::add(std::span<const JointRows> palette) {
    const Place place = newPlace(palette.size());
    std::vector<JointRows>& joints = pages_[place.page].joints;
    joints.insert(joints.end(), palette.begin(), palette.end());
    return place;
}

void JointPalette::upload() {
    for (std::size_t i = 0; i < pagesInUse_; ++i) {
        pages_[i].texture.store(std::span<const JointRows>(pages_[i].joints), GL_STREAM_DRAW);
    }
}

void JointPalette::bind(std::size_t page, int unit) const {
    pages_[page].texture.bind(unit);
}

}  // namespace walkcycle
