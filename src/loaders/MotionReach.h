#pragma once

#include <vector>

#include "loaders/KeyForms.h"
#include "loaders/Motion.h"
#include "model/Model.h"

namespace walkcycle {

// Where motion shows: how large the model is, and how far from each joint the points hang that it moves. Taken from
// the model's geometry as it stands at one time; in the document's own units.
class MotionReach {
public:
    MotionReach(const Model& model, const Motion& motion, double seconds);

    double modelSize() const { return modelSize_; }  // diagonal of the box around the model

    // How far off a joint may be, so that the errors of all joints on the way to a vertex stay within `share` of the
    // model's size together.
    Tolerance tolerance(int joint, double share) const;
    Tolerance tolerance(const Parameter& parameter, const Model& model, double share) const;

    // Smaller shares are taken as this one: the numbers of a key are floats, which cannot tell less.
    static constexpr double finestShare() { return 6e-8; }

    // The largest distance between exact and keyed points, as a share of the model's size, seen at some moments
    // between the clip's start and end that have nothing to do with the keys.
    double measure(const Model& model, const Motion& motion, const Animation& animation) const;

private:
    struct Box {
        glm::dvec3 min{1e300}, max{-1e300};
        bool empty() const { return min.x > max.x; }
        void add(const glm::dvec3& point) { min = glm::min(min, point), max = glm::max(max, point); }
        glm::dvec3 corner(int i) const {
            return {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
        }
        // How far a matrix takes any of its corners from the origin.
        double farthestSquared(const glm::dmat4& matrix) const;
    };
    void addInstance(const Model& model, const MeshInstance& instance, Box& modelBox);
    void addSkinned(const Model& model, const MeshInstance& instance, const Deformer& deformer,
                    Box& modelBox);
    void measureJoints(const Model& model);
    void countMoving(const Model& model, const Motion& motion);

    std::vector<glm::dmat4> worlds_;
    std::vector<Box> boxes_;       // per joint, in its own space: the points that it moves itself
    std::vector<double> units_;    // per joint: model length of one unit of its parent
    std::vector<double> reaches_;  // per joint: in its own units
    std::vector<int> moving_;      // per joint: how many joints move on the longest way through it
    double modelSize_ = 1.0;
};

}  // namespace walkcycle
