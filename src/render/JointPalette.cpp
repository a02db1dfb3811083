#include "render/JointPalette.h"

#include <cassert>

namespace walkcycle {
namespace {

constexpr std::size_t kRowsPerJoint = 3;

glm::vec4 row(const glm::mat4& matrix, int i) {
    return {matrix[0][i], matrix[1][i], matrix[2][i], matrix[3][i]};
}

}  // namespace

JointPalette::JointPalette(std::size_t maxTexels) : maxJoints_(maxTexels / kRowsPerJoint) {}

void JointPalette::clear() {
    for (Page& page : pages_) page.rows.clear();
    pagesInUse_ = 0;
}

JointPalette::Place JointPalette::add(std::span<const glm::mat4> palette) {
    assert(palette.size() <= maxJoints_);
    const auto joints = [&] { return pages_[pagesInUse_ - 1].rows.size() / kRowsPerJoint; };
    if (pagesInUse_ == 0 || joints() + palette.size() > maxJoints_) {
        if (++pagesInUse_ > pages_.size()) pages_.emplace_back();
    }
    const Place place{pagesInUse_ - 1, static_cast<int>(joints())};
    std::vector<glm::vec4>& rows = pages_[place.page].rows;
    for (const glm::mat4& matrix : palette) {
        for (int i = 0; i < 3; ++i) rows.push_back(row(matrix, i));
    }
    return place;
}

void JointPalette::upload() {
    for (std::size_t i = 0; i < pagesInUse_; ++i) {
        pages_[i].texture.store(std::span<const glm::vec4>(pages_[i].rows), GL_STREAM_DRAW);
    }
}

void JointPalette::bind(std::size_t page, int unit) const {
    pages_[page].texture.bind(unit);
}

}  // namespace walkcycle
