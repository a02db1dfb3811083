#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/animation/JointRows.h>

namespace walkcycle {

// What binds a mesh to a skeleton: entry i of a vertex's joint ids means joint joints[i].
// The last entry is the skin's own node, with an identity inverse bind matrix: vertices without influence, and
// joint index -1 of the file, follow it.
struct Skin {
    std::vector<int> joints;  // indices into Skeleton::joints
    // inverseBindMatrix * bindShapeMatrix, per joint, multiplied once when the skin is loaded: from the mesh's space
    // to the model's at bind time, and from there to the joint's.
    std::vector<glm::mat4> bindMatrices;

    // Some exporters (Maya's ColladaMaya, Softimage) want the node's transform, relative to
    // `placedRelativeTo`, on top of the joints': the nearest common ancestor of the node and the joints.
    // kNoParent as `placedBy`: the joints alone place the skin, as everywhere else. kNoParent as
    // `placedRelativeTo`: node and joints meet nowhere below the scene's root, whose transform
    // (Skeleton::rootTransform) `placedInRoot` then is.
    int placedBy = kNoParent;
    int placedRelativeTo = kNoParent;
    glm::mat4 placedInRoot{1.0f};
};

// palette[i] = modelTransform[skin.joints[i]] * bindMatrix[i]: mesh space -> model space. If the node places the
// skin, every entry but the last (which follows the node already) is multiplied from the left by
// modelTransform[placedBy] * inverse(modelTransform[placedRelativeTo]).
// `palette` is resized to the skin's joint count; its memory is reused.
WALKCYCLE_API void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                                  std::vector<glm::mat4>& palette);

// The same as rows, into memory of the caller's: one entry per joint of the skin.
WALKCYCLE_API void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                                  std::span<JointRows> palette);

}  // namespace walkcycle
