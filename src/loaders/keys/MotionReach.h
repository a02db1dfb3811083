#pragma once

#include <vector>

#include "loaders/curves/Motion.h"
#include "loaders/keys/KeyForms.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The effect of an error of a joint: the size of the model, and the distance from each joint to the farthest
// point that it moves. Both are measured on the geometry as posed at one time. Model space is in the
// document's own unit here.
class MotionReach {
public:
    MotionReach(const Model& model, const Motion& motion, double seconds);

    double modelSize() const { return modelSize_; }  // diagonal of the model's bounding box

    // The tolerance of a joint, if all joints between the root and a vertex together may be off by `share` of
    // the size of the model; and that of a parameter.
    Tolerance tolerance(int joint, double share) const;
    Tolerance tolerance(const Parameter& parameter, const Model& model, double share) const;

    // The smallest useful share: the numbers of a key are floats.
    static constexpr double finestShare() { return 6e-8; }

    // The largest distance between exact and keyed points, as a share of the size of the model, at some times
    // between the start and the end of the clip. The times do not depend on the keys.
    double measure(const Model& model, const Motion& motion, const Animation& animation) const;

private:
    struct Box {
        glm::dvec3 min{1e300}, max{-1e300};
        bool empty() const { return min.x > max.x; }
        void add(const glm::dvec3& point) { min = glm::min(min, point), max = glm::max(max, point); }
        glm::dvec3 corner(int i) const {
            return {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
        }
        // The largest squared distance from the origin to a corner that the matrix transforms.
        double farthestSquared(const glm::dmat4& matrix) const;
    };
    void addInstance(const Model& model, const MeshInstance& instance, Box& modelBox);
    void addSkinned(const Model& model, const MeshInstance& instance, const Deformer& deformer,
                    Box& modelBox);
    void measureJoints(const Model& model);
    void countMoving(const Model& model, const Motion& motion);

    std::vector<glm::dmat4> worlds_;  // per joint: its model transform
    std::vector<Box>
        boxes_;  // per joint, in its own space: the points that it moves itself, without its children
    std::vector<double> units_;    // per joint: length in model space of one unit of its parent
    std::vector<double> reaches_;  // per joint: see Tolerance::reach
    std::vector<int> moving_;  // per joint: the most moving joints on a path from a root through it to a leaf
    double modelSize_ = 1.0;
};

}  // namespace walkcycle
