#include "crowd/FastPoser.h"

#include <cassert>
#include <utility>

#include "animation/SkinPlacement.h"
#include "crowd/TimelineBuilder.h"
#include "walkcycle/animation/Animator.h"

namespace walkcycle {
namespace {

Rows toRows(const glm::mat4& matrix) {
    return load(JointRows(matrix));
}

glm::mat4 toMatrix(const Rows& rows) {
    JointRows joint;
    store(rows, joint);
    return joint.toMatrix();
}

// Numbers the joints that the skin depends on (its own and all their ancestors) in the skeleton's order; -1 for the rest.
std::vector<int> slotsOf(const Skeleton& skeleton, const Skin& skin) {
    std::vector<bool> matters(skeleton.joints.size(), false);
    for (const int joint : skin.joints) matters[static_cast<std::size_t>(joint)] = true;
    for (const int joint : {skin.placedBy, skin.placedRelativeTo})
        if (joint != kNoParent) matters[static_cast<std::size_t>(joint)] = true;
    for (std::size_t i = matters.size(); i-- > 0;) {
        const int parent = skeleton.joints[i].parent;
        if (matters[i] && parent != kNoParent) matters[static_cast<std::size_t>(parent)] = true;
    }
    std::vector<int> slots;
    int next = 0;
    for (const bool matter : matters) slots.push_back(matter ? next++ : -1);
    return slots;
}

}  // namespace

FastPoser::FastPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin) {
    const std::vector<int> slots = slotsOf(skeleton, skin);
    const auto slotOf = [&](int joint) {
        return joint == kNoParent ? kNoParent : slots[static_cast<std::size_t>(joint)];
    };
    auto tables = std::make_shared<Tables>();
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (slots[i] < 0) continue;
        tables->parents.push_back(slotOf(skeleton.joints[i].parent));
        tables->rest.push_back(toRows(skeleton.joints[i].localBindTransform));
    }
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
        tables->palette.push_back(
            {static_cast<std::size_t>(slotOf(skin.joints[i])), toRows(skin.bindMatrices[i])});
    tables->root = toRows(skeleton.rootTransform);
    tables->placedBy = slotOf(skin.placedBy);
    tables->placedRelativeTo = slotOf(skin.placedRelativeTo);
    tables->placedInRoot = skin.placedInRoot;
    tables->start = animation.startSeconds;
    tables->length = animation.lengthInSeconds();
    tables->timelines = makeTimelines(animation, slots);
    locals_ = tables->rest;
    models_.resize(locals_.size());
    tables_ = std::move(tables);
}

void FastPoser::poseOne(double documentSeconds, std::span<JointRows> palette) {
    const Tables& tables = *tables_;
    for (const ClipTimeline& timeline : tables.timelines) timeline.sample(documentSeconds, locals_);
    for (std::size_t i = 0; i < models_.size(); ++i) {
        const int parent = tables.parents[i];
        models_[i] = (parent < 0 ? tables.root : models_[static_cast<std::size_t>(parent)]) * locals_[i];
    }
    for (std::size_t i = 0; i < palette.size(); ++i)
        store(models_[tables.palette[i].slot] * tables.palette[i].toJoint, palette[i]);
    if (tables.placedBy == kNoParent || palette.empty()) return;
    const auto modelTransform = [&](int slot) { return toMatrix(models_[static_cast<std::size_t>(slot)]); };
    place(palette.first(palette.size() - 1), skinPlacement(tables, modelTransform));
}

void FastPoser::pose(std::span<const double> seconds, std::span<JointRows> palettes) {
    assert(palettes.size() >= seconds.size() * paletteSize());
    for (std::size_t i = 0; i < seconds.size(); ++i)
        poseOne(tables_->start + loop(seconds[i], tables_->length),
                palettes.subspan(i * paletteSize(), paletteSize()));
}

std::size_t FastPoser::tableBytes() const {
    std::size_t sum = 0;
    for (const ClipTimeline& timeline : tables_->timelines) sum += timeline.bytes();
    return sum;
}

}  // namespace walkcycle
