#include "animation/FastPoser.h"

#include <cassert>
#include <cmath>

#include <glm/matrix.hpp>

#include "animation/Animator.h"
#include "animation/ClipTimeline.h"
#include "animation/TimelineBuilder.h"

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

// The joints that the skin hangs on, with all above them: a place in the order of the skeleton, or -1.
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

struct FastPoser::Tables {
    struct Entry {
        std::size_t slot = 0;
        Rows toJoint{};  // mesh space -> joint space
    };
    std::vector<ClipTimeline> timelines;
    std::vector<int> parents;  // per slot
    std::vector<Rows> rest;    // per slot: the local transform of what does not move
    Rows root{};
    std::vector<Entry> palette;
    int placedBy = kNoParent, placedRelativeTo = kNoParent;  // slots
    glm::mat4 placedInRoot{1.0f};
    double start = 0.0, length = 0.0;

    double timeOf(double seconds) const { return start + loop(seconds, length); }

    // As computePalette has it.
    Rows placement(const std::vector<Rows>& models) const {
        const glm::mat4 meetingPoint = placedRelativeTo == kNoParent
                                           ? placedInRoot
                                           : toMatrix(models[static_cast<std::size_t>(placedRelativeTo)]);
        if (!std::isnormal(glm::determinant(meetingPoint))) return toRows(glm::mat4(1.0f));
        return toRows(toMatrix(models[static_cast<std::size_t>(placedBy)]) * glm::inverse(meetingPoint));
    }
};

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

std::size_t FastPoser::paletteSize() const {
    return tables_->palette.size();
}

double FastPoser::lengthInSeconds() const {
    return tables_->length;
}

void FastPoser::walk() {
    const int* parents = tables_->parents.data();
    for (std::size_t i = 0; i < models_.size(); ++i)
        models_[i] =
            (parents[i] < 0 ? tables_->root : models_[static_cast<std::size_t>(parents[i])]) * locals_[i];
}

void FastPoser::pose(double seconds, std::span<JointRows> palette) {
    assert(palette.size() >= paletteSize());
    const double time = tables_->timeOf(seconds);
    for (const ClipTimeline& timeline : tables_->timelines) timeline.sample(time, locals_);
    walk();
    const std::size_t count = tables_->palette.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Tables::Entry& entry = tables_->palette[i];
        store(models_[entry.slot] * entry.toJoint, palette[i]);
    }
    if (tables_->placedBy == kNoParent) return;
    const Rows placed = tables_->placement(models_);
    for (std::size_t i = 0; i + 1 < count; ++i) store(placed * load(palette[i]), palette[i]);
}

// While one character is posed, the memory that the next one needs is on its way.
void FastPoser::pose(std::span<const double> seconds, std::span<JointRows> palettes) {
    assert(palettes.size() >= seconds.size() * paletteSize());
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        if (i + 1 < seconds.size())
            for (const ClipTimeline& timeline : tables_->timelines)
                timeline.prefetch(tables_->timeOf(seconds[i + 1]));
        pose(seconds[i], palettes.subspan(i * paletteSize(), paletteSize()));
    }
}

std::size_t FastPoser::tableBytes() const {
    std::size_t sum = 0;
    for (const ClipTimeline& timeline : tables_->timelines) sum += timeline.bytes();
    return sum;
}

}  // namespace walkcycle
