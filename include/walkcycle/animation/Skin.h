#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/animation/JointRows.h>

namespace walkcycle {

// Binds a mesh to a skeleton: joint id i of a vertex means joint joints[i].
// The last entry is the skin's own node, with an identity inverse bind matrix: vertices without influences, and
// influences with joint index -1 in the file, follow it.
struct Skin {
    std::vector<int> joints;  // indices into Skeleton::joints
    // inverseBindMatrix * bindShapeMatrix, per joint, multiplied once when the skin is loaded: from mesh space to
    // model space at bind time, and from there to joint space.
    std::vector<glm::mat4> bindMatrices;

    // The quirk skin-by-node: the transform of the skin's node (`placedBy`), relative to the nearest common ancestor
    // of the node and the joints (`placedRelativeTo`), is applied on top of the joints. Both are indices into
    // Skeleton::joints. If `placedBy` is kNoParent, the joints alone place the skin. If `placedRelativeTo` is kNoParent,
    // the only common ancestor is the scene's root, and `placedInRoot` is its transform (Skeleton::rootTransform).
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

// The same as rows. `palette` must have one entry per joint of the skin.
WALKCYCLE_API void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                                  std::span<JointRows> palette);

}  // namespace walkcycle
