#pragma once

#include <span>
#include <string>

#include "app/ExactPose.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The JSON of `pose`: the model transform of each joint and the deformed positions of each instance, at each of the
// times. `poses` has one entry per time; matrices are written row by row.
template <typename Number>
std::string poseJson(const Model& model, std::span<const double> times,
                     std::span<const PosedModel<Number>> poses);

extern template std::string poseJson(const Model&, std::span<const double>,
                                     std::span<const PosedModel<float>>);
extern template std::string poseJson(const Model&, std::span<const double>,
                                     std::span<const PosedModel<double>>);

}  // namespace walkcycle
