#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "crowd/ClipTimeline.h"
#include "walkcycle/animation/Animation.h"
#include "walkcycle/animation/Joint.h"
#include "walkcycle/animation/JointRows.h"
#include "walkcycle/animation/Skin.h"

namespace walkcycle {

// What CrowdPoser has on each of its threads: makes the palettes of one clip for one skin from tables (ClipTimeline). Four
// joints are blended at once, transforms are three rows instead of four columns, and joints that do not reach the skin
// are left out. Copies share the tables.
class FastPoser {
public:
    // Keeps nothing of its arguments.
    FastPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin);

    std::size_t paletteSize() const { return tables_->palette.size(); }
    double lengthInSeconds() const { return tables_->length; }

    // As CrowdPoser::pose. One after the other, allocates nothing.
    void pose(std::span<const double> seconds, std::span<JointRows> palettes);

    std::size_t tableBytes() const;  // what all copies share

private:
    struct Entry {
        std::size_t slot = 0;
        Rows toJoint{};  // mesh space -> joint space
    };
    struct Tables {
        std::vector<ClipTimeline> timelines;
        std::vector<int> parents;  // per slot
        std::vector<Rows> rest;    // per slot: the local transform of what does not move
        Rows root{};
        std::vector<Entry> palette;
        int placedBy = kNoParent, placedRelativeTo = kNoParent;  // slots
        glm::mat4 placedInRoot{1.0f};
        double start = 0.0, length = 0.0;
    };
    void poseOne(double documentSeconds, std::span<JointRows> palette);

    std::shared_ptr<const Tables> tables_;
    std::vector<Rows> locals_, models_;  // per slot: of the joints that matter, parents first
};

}  // namespace walkcycle
