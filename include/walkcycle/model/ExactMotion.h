#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

// The file's own curves and transform stacks, evaluated directly in double precision. The error of the key
// frames of Model::animations is measured against it, and `pose --exact` prints it.
class WALKCYCLE_API ExactMotion {
public:
    virtual ~ExactMotion() = default;

    // Fills one local transform per joint of the skeleton, and one value per Model::parameters, at a time of
    // the document's timeline (the whole of it, as of animations[0]).
    virtual void evaluate(double seconds, std::span<glm::dmat4> localTransforms,
                          std::span<double> parameters) const = 0;
};

}  // namespace walkcycle
