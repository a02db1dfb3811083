#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "animation/Joint.h"

namespace walkcycle {

// What binds a mesh to a skeleton: entry i of a vertex's joint ids means joint joints[i].
// The last entry is the skin's own node with an identity inverse bind matrix: vertices without influence, and
// joint index -1 of the file, follow it.
struct Skin {
    std::vector<int> joints;                     // indices into Skeleton::joints
    std::vector<glm::mat4> inverseBindMatrices;  // model space at bind time -> joint space
    glm::mat4 bindShapeMatrix{1.0f};             // mesh space -> model space at bind time

    // Some exporters (Maya's ColladaMaya, Softimage) want the node's transform, relative to
    // `placedRelativeTo`, on top of the joints': the nearest common ancestor of the node and the joints.
    // kNoParent as `placedBy`: the joints alone place the skin, as everywhere else. kNoParent as
    // `placedRelativeTo`: node and joints meet nowhere below the scene's root, whose transform
    // (Skeleton::rootTransform) `placedInRoot` then is.
    int placedBy = kNoParent;
    int placedRelativeTo = kNoParent;
    glm::mat4 placedInRoot{1.0f};
};

// palette[i] = modelTransform[skin.joints[i]] * inverseBindMatrix[i] * bindShapeMatrix: mesh space -> model
// space. Where the node places the skin, all but the last entry (which hangs on the node already) have
// modelTransform[placedBy] * inverse(modelTransform[placedRelativeTo]) before them.
// `palette` is resized to the skin's joint count; its memory is reused.
void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                    std::vector<glm::mat4>& palette);

}  // namespace walkcycle
