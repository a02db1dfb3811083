#pragma once

#include <span>
#include <string>

#include "app/ExactPose.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The JSON that `pose` prints. `poses` has one entry per time.
template <typename Number>
std::string poseJson(const Model& model, std::span<const double> times,
                     std::span<const PosedModel<Number>> poses);

extern template std::string poseJson(const Model&, std::span<const double>,
                                     std::span<const PosedModel<float>>);
extern template std::string poseJson(const Model&, std::span<const double>,
                                     std::span<const PosedModel<double>>);

}  // namespace walkcycle
