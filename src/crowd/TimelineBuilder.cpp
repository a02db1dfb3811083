#include "crowd/TimelineBuilder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "crowd/ExactChannel.h"

namespace walkcycle {
namespace {

using Side = ExactChannel::Side;
using Group = ClipTimeline::Group;

constexpr std::size_t kLanes = 4;

constexpr std::size_t kMostTimesTheKeys = 4;  // how many transforms a shared timeline may hold per key
constexpr std::size_t kSmall = 1024;          // transforms that any timeline may hold
constexpr double kSame = 1e-8;                // relative; a float cannot hold a smaller difference

// Flags: what a channel changes, and in which form. Lanes are sorted by kind, so that similar ones share a group.
enum Kind : unsigned int { kRotates = 1, kScales = 2, kMoves = 4, kCubic = 8, kMatrix = 16 };

// The channel of one joint, to be written into one lane of a timeline's Float4s.
struct Lane {
    ExactChannel channel;
    int slot = 0;
    unsigned int kind = 0;
};

// The time of a row. A jump has two rows, one for each side.
struct RowTime {
    double seconds = 0.0;
    Side side = Side::Right;
};

std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> both;
    both.reserve(std::max(a.size(), b.size()));
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

glm::dquat nearest(const glm::dquat& a, const glm::dquat& b) {
    return glm::dot(a, b) < 0.0 ? -b : b;
}

bool differ(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(a, b) > kSame * glm::length(b);
}

// Writes the timeline that some channels share.
class TimelineWriter {
public:
    explicit TimelineWriter(std::span<Lane> lanes) : lanes_(lanes) {}

    ClipTimeline write(const std::vector<double>& times) {
        makeRows(times);
        for (Lane& lane : lanes_) lane.kind = kindOf(lane.channel);
        std::stable_sort(lanes_.begin(), lanes_.end(),
                         [](const Lane& a, const Lane& b) { return a.kind < b.kind; });
        layOut();
        timeline_.numbers.resize((rows_.size() + 1) * timeline_.width, splat(0.0f));
        for (std::size_t row = 0; row < rows_.size(); ++row) fill(row);
        const auto width = static_cast<std::ptrdiff_t>(timeline_.width);
        std::copy_n(timeline_.numbers.end() - 2 * width, width, timeline_.numbers.end() - width);
        return std::move(timeline_);
    }

private:
    void makeRows(const std::vector<double>& times) {
        std::vector<double> jumps;
        for (const Lane& lane : lanes_) jumps = merged(jumps, lane.channel.jumps());
        for (const double seconds : times) {
            if (std::binary_search(jumps.begin(), jumps.end(), seconds))
                rows_.push_back({seconds, Side::Left});
            rows_.push_back({seconds, Side::Right});
        }
        for (const RowTime& row : rows_) timeline_.times.push_back(row.seconds);
        const double rate =
            static_cast<double>(rows_.size() - 1) / (rows_.back().seconds - rows_.front().seconds);
        timeline_.rowsPerSecond = std::isfinite(rate) ? rate : 0.0;
    }

    // Compares each row with the first one, since a slow drift is too small from row to row.
    unsigned int kindOf(const ExactChannel& channel) const {
        if (channel.isMatrix()) return kMatrix;
        if (channel.isCubic()) return kCubic | kRotates | kScales | kMoves;
        unsigned int kind = 0;
        const ExactTransform first = channel.transformAt(rows_.front().seconds, rows_.front().side);
        for (const RowTime& row : rows_) {
            const ExactTransform at = channel.transformAt(row.seconds, row.side);
            const glm::dquat rotated = nearest(first.rotation, at.rotation) - first.rotation;
            if (std::sqrt(glm::dot(rotated, rotated)) > kSame) kind |= kRotates;
            if (differ(at.scale, first.scale)) kind |= kScales;
            if (differ(at.position, first.position)) kind |= kMoves;
        }
        return kind;
    }

    int place(bool isNeeded, std::size_t numbers) {
        if (!isNeeded) return Group::kNoPlace;
        timeline_.width += numbers;
        return static_cast<int>(timeline_.width - numbers);
    }

    void layOut() {
        std::size_t next = 0;
        while (next < lanes_.size() && lanes_[next].kind != kMatrix) next = addGroup(next);
        for (; next < lanes_.size(); ++next)
            timeline_.matrices.push_back({lanes_[next].slot, place(true, 3)});
    }

    // Makes a group of up to four lanes. Returns the lane that follows them.
    std::size_t addGroup(std::size_t first) {
        Group group;
        unsigned int kind = lanes_[first].kind;
        std::size_t end = first + 1;
        for (; end < std::min(lanes_.size(), first + kLanes); ++end) {
            if ((lanes_[end].kind ^ kind) & (kMatrix | kCubic)) break;
            kind |= lanes_[end].kind;
        }
        group.isCubic = (kind & kCubic) != 0;
        const std::size_t each = group.isCubic ? 4 : 1;
        group.rotationAt = place(kind & kRotates, 4 * each);
        group.positionAt = place(kind & kMoves, 3 * each);
        group.scaleAt = place(kind & kScales, 3 * each);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t lane = std::min(first + i, end - 1);
            group.slots[i] = lanes_[lane].slot;
            members_.push_back(&lanes_[lane]);
        }
        timeline_.groups.push_back(group);
        return end;
    }

    void fill(std::size_t row) {
        Float4* numbers = timeline_.numbers.data() + row * timeline_.width;
        for (std::size_t g = 0; g < timeline_.groups.size(); ++g)
            for (std::size_t i = 0; i < kLanes; ++i) {
                const ExactChannel& channel = members_[g * kLanes + i]->channel;
                if (timeline_.groups[g].isCubic)
                    fillCubic(channel, timeline_.groups[g], row, i, numbers);
                else
                    fillStraight(channel, timeline_.groups[g], row, i, numbers);
            }
        const std::size_t firstMatrix = lanes_.size() - timeline_.matrices.size();
        for (std::size_t m = 0; m < timeline_.matrices.size(); ++m) {
            const ExactChannel& channel = lanes_[firstMatrix + m].channel;
            const glm::dmat4 matrix = channel.matrixAt(rows_[row].seconds, rows_[row].side);
            const Rows rows = load(JointRows(glm::mat4(matrix)));
            Float4* into = numbers + timeline_.matrices[m].at;
            into[0] = rows.x, into[1] = rows.y, into[2] = rows.z;
        }
    }

    void fillStraight(const ExactChannel& channel, Group& group, std::size_t row, std::size_t lane,
                      Float4* numbers) const {
        auto at = channel.transformAt(rows_[row].seconds, rows_[row].side);
        const auto store = [&](int place, Float4* constant, const auto& values, int count) {
            Float4* into = place == Group::kNoPlace ? constant : numbers + place;
            for (int c = 0; c < count; ++c) into[c][static_cast<int>(lane)] = static_cast<float>(values[c]);
        };
        if (row > 0 && group.rotationAt != Group::kNoPlace) {
            const Float4* before = numbers - timeline_.width + group.rotationAt;
            double side = 0.0;
            for (int c = 0; c < 4; ++c)
                side += static_cast<double>(before[c][static_cast<int>(lane)]) * at.rotation[c];
            if (side < 0.0) at.rotation = -at.rotation;
        }
        store(group.rotationAt, group.rotation.data(), at.rotation, 4);
        store(group.positionAt, group.position.data(), at.position, 3);
        store(group.scaleAt, group.scale.data(), at.scale, 3);
    }

    void fillCubic(const ExactChannel& channel, const Group& group, std::size_t row, std::size_t lane,
                   Float4* numbers) const {
        const double begin = rows_[row].seconds;
        const double end = row + 1 < rows_.size() ? rows_[row + 1].seconds : begin;
        int place = group.rotationAt;  // followed by position and scale
        for (const ExactChannel::Cubic& curve : channel.cubicsBetween(begin, end))
            for (const double coefficient : curve)
                numbers[place++][static_cast<int>(lane)] = static_cast<float>(coefficient);
    }

    std::span<Lane> lanes_;
    std::vector<RowTime> rows_;
    std::vector<const Lane*> members_;  // four per group
    ClipTimeline timeline_;
};

// Whether so many channels may share a timeline of so many rows: it must not hold many more numbers than their keys.
bool fits(std::size_t rows, std::size_t lanes, std::size_t keys) {
    return rows * lanes <= kMostTimesTheKeys * keys + kSmall;
}

}  // namespace

std::vector<ClipTimeline> makeTimelines(const Animation& animation, std::span<const int> slots) {
    std::vector<Lane> lanes;
    std::vector<bool> taken(slots.size());
    for (auto channel = animation.channels.rbegin(); channel != animation.channels.rend(); ++channel) {
        const auto joint = static_cast<std::size_t>(channel->joint);
        if (slots[joint] < 0 || taken[joint]) continue;
        if (channel->keyFrames.empty() && channel->matrixKeyFrames.empty()) continue;
        taken[joint] = true;
        lanes.push_back({ExactChannel(*channel), slots[joint]});
    }
    std::stable_sort(lanes.begin(), lanes.end(), [](const Lane& a, const Lane& b) {
        return a.channel.times().size() > b.channel.times().size();
    });
    std::vector<ClipTimeline> timelines;
    for (std::size_t first = 0; first < lanes.size();) {
        std::vector<double> times = lanes[first].channel.times();
        std::size_t keys = times.size(), end = first + 1;
        for (; end < lanes.size(); ++end) {
            std::vector<double> both = merged(times, lanes[end].channel.times());
            keys += lanes[end].channel.times().size();
            if (!fits(both.size(), end + 1 - first, keys)) break;
            times = std::move(both);
        }
        timelines.push_back(TimelineWriter(std::span(lanes).subspan(first, end - first)).write(times));
        first = end;
    }
    return timelines;
}

}  // namespace walkcycle
