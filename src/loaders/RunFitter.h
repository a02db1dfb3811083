#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "loaders/KeyForms.h"

namespace walkcycle {

// Finds few keys for a run of motion without jumps: first as many as the tolerance asks for, halving where the way
// between two strays, then leaves out those that their neighbours can do without.
template <typename Form>
struct RunKeys {
    std::vector<double> times;
    std::vector<typename Form::Value> values;  // one per time
    std::vector<Form> pieces;                  // one between each two, of forms with tangents
    bool isWithin = true;                      // the tolerance; false where the limit came first
};

// `Exact` gives the motion's value at any time of the run.
template <typename Form, typename Exact>
class RunFitter {
public:
    using Value = typename Form::Value;
    using Keys = RunKeys<Form>;

    // `isStraight`: the motion is known to go in this very form between its knots. No more than `limit` keys are made.
    RunFitter(Exact exact, const Tolerance& tolerance, bool isStraight, std::size_t limit)
        : exact_(std::move(exact)), tolerance_(tolerance), isStraight_(isStraight), limit_(limit) {}

    Keys fit(const std::vector<double>& knots) {
        samples_.reserve(knots.size());
        nodes_.reserve(knots.size());
        samples_ = {{knots.front(), exact_(knots.front())}};
        nodes_ = {0};
        for (std::size_t i = 1; i < knots.size(); ++i) refine(knots[i]);
        return leaveOut();
    }

private:
    struct Sample {
        double seconds;
        Value value;
    };

    // Adds the way from the last node to a time to the samples, with as few nodes as needed.
    void refine(double to) {
        if (isStraight_) return addNode({to, exact_(to)});
        constexpr double kShare = 0.4;  // of the budget: what is left out later needs the rest
        constexpr int kDeepest = 24;
        std::vector<std::pair<double, int>>& ends = ends_;
        std::vector<Sample>& probes = probes_;
        ends.assign(1, {to, 0});
        while (!ends.empty()) {
            const auto [end, depth] = ends.back();
            const Sample start = samples_[nodes_.back()], stop{end, exact_(end)};
            probes.clear();
            const double strayed = probe(start, stop, probes);
            const bool maySplit = depth < kDeepest && nodes_.size() + ends.size() < limit_;
            isWithin_ = isWithin_ && (maySplit || strayed <= tolerance_.budget);
            if (strayed > kShare * tolerance_.budget && maySplit) {
                ends.back().second = depth + 1;
                ends.emplace_back(0.5 * (start.seconds + end), depth + 1);
                continue;
            }
            samples_.insert(samples_.end(), probes.begin(), probes.end());
            addNode(stop);
            ends.pop_back();
        }
    }

    void addNode(const Sample& sample) {
        nodes_.push_back(samples_.size());
        samples_.push_back(sample);
    }

    double probe(const Sample& start, const Sample& stop, std::vector<Sample>& probes) {
        const Form piece = Form::through(exact_, start.seconds, stop.seconds, start.value, stop.value);
        double strayed = 0.0;
        for (int i = 1; i < 6; ++i) {
            const double seconds = start.seconds + (stop.seconds - start.seconds) * (i / 6.0);
            probes.push_back({seconds, exact_(seconds)});
            strayed = std::max(strayed, distance(probes.back().value, piece.at(i / 6.0), tolerance_));
        }
        return strayed;
    }

    // From each key to the farthest node that one piece can reach: by doubling strides, then halving.
    Keys leaveOut() {
        Keys keys{{samples_.front().seconds}, {samples_.front().value}, {}, isWithin_};
        const std::size_t last = nodes_.size() - 1;
        for (std::size_t a = 0; a < last;) {
            std::size_t good = a + 1, bad = last + 1;
            std::optional<Form> piece;  // to there, where it is not the next one
            for (std::size_t b = a + 2; b <= last && bad > last;) {
                const Form wider = pieceTo(keys.values.back(), a, b);
                if (fits(wider, a, b)) {
                    good = b, piece = wider;
                    b = b == last ? last + 1 : std::min(last, a + (b - a) * 2);
                } else {
                    bad = b;
                }
            }
            while (bad <= last && bad - good > 1) {
                const std::size_t b = (good + bad) / 2;
                const Form wider = pieceTo(keys.values.back(), a, b);
                if (fits(wider, a, b))
                    good = b, piece = wider;
                else
                    bad = b;
            }
            const Sample& reached = samples_[nodes_[good]];
            keys.times.push_back(reached.seconds);
            if constexpr (Form::kHasTangents) {
                if (!piece) piece = pieceTo(keys.values.back(), a, good);
                keys.values.push_back(piece->end());
                keys.pieces.push_back(*piece);
            } else {
                keys.values.push_back(reached.value);
            }
            a = good;
        }
        return keys;
    }

    Form pieceTo(const Value& start, std::size_t a, std::size_t b) const {
        const Sample& from = samples_[nodes_[a]];
        const Sample& to = samples_[nodes_[b]];
        return Form::through(exact_, from.seconds, to.seconds, start, to.value);
    }

    bool fits(const Form& piece, std::size_t a, std::size_t b) const {
        const double from = samples_[nodes_[a]].seconds, length = samples_[nodes_[b]].seconds - from;
        for (std::size_t i = nodes_[a] + 1; i < nodes_[b]; ++i)
            if (distance(samples_[i].value, piece.at((samples_[i].seconds - from) / length), tolerance_) >
                tolerance_.budget)
                return false;
        return true;
    }

    Exact exact_;
    Tolerance tolerance_;
    bool isStraight_;
    std::size_t limit_;
    std::vector<Sample> samples_;
    std::vector<std::pair<double, int>> ends_;  // what refine() works with, kept for its memory
    std::vector<Sample> probes_;
    bool isWithin_ = true;
    std::vector<std::size_t> nodes_;  // indices of the samples that may become keys
};

}  // namespace walkcycle
