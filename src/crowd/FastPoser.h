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

// Computes the palettes of one clip for one skin from tables (ClipTimeline). It blends four joints at once, keeps
// transforms as three rows instead of four columns, and leaves out joints that the skin does not depend on. CrowdPoser
// has one per thread; copies share the tables.
class FastPoser {
public:
    // Copies what it needs from its arguments.
    FastPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin);

    std::size_t paletteSize() const { return tables_->palette.size(); }
    double lengthInSeconds() const { return tables_->length; }

    // As CrowdPoser::pose, but on the calling thread alone. Allocates nothing.
    void pose(std::span<const double> seconds, std::span<JointRows> palettes);

    std::size_t tableBytes() const;  // size of the tables that all copies share

private:
    struct Entry {
        std::size_t slot = 0;
        Rows toJoint{};  // mesh space -> joint space
    };
    struct Tables {
        std::vector<ClipTimeline> timelines;
        std::vector<int> parents;  // per slot
        std::vector<Rows> rest;    // per slot: the local transform, for joints that do not move
        Rows root{};
        std::vector<Entry> palette;
        int placedBy = kNoParent, placedRelativeTo = kNoParent;  // slots, or kNoParent; see Skin
        glm::mat4 placedInRoot{1.0f};
        double start = 0.0, length = 0.0;
    };
    void poseOne(double documentSeconds, std::span<JointRows> palette);

    std::shared_ptr<const Tables> tables_;
    std::vector<Rows> locals_, models_;  // per slot, parents first: local and model transforms
};

}  // namespace walkcycle
