#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

// The motion of a document, evaluated from the file's own curves and transform stacks in double precision.
// The error of the key frames in Model::animations (Animation::achievedError) is measured against it.
class WALKCYCLE_API ExactMotion {
public:
    virtual ~ExactMotion() = default;

    // Fills one local transform per joint of the skeleton (relative to the parent, in the document's own unit
    // and axes) and one value per Model::parameters. `seconds` is a time of the whole timeline, as in
    // Model::animations[0]. Longer spans keep their other entries.
    virtual void evaluate(double seconds, std::span<glm::dmat4> localTransforms,
                          std::span<double> parameters) const = 0;
};

}  // namespace walkcycle
