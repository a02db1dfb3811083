#include "profiles/Profile.h"

#include <algorithm>
#include <array>

#include "profiles/Rules.h"

namespace walkcycle {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"gltf", "gazebo", "secondlife", "thinmatrix"};

}  // namespace

std::span<const std::string_view> profileNames() {
    return kNames;
}

std::optional<Profile> profileNamed(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Profile>(found - kNames.begin());
}

void checkProfile(Profile profile, const Inspection& inspection) {
    const Subject subject(inspection);
    switch (profile) {
        case Profile::Gltf:
            return checkGltf(subject);
        case Profile::Gazebo:
            checkGazebo(subject);
            checkGazeboMotion(subject);
            return checkGazeboMaterials(subject);
        case Profile::SecondLife:
            return checkSecondLife(subject);
        case Profile::ThinMatrix:
            checkThinMatrix(subject);
            return checkThinMatrixMotion(subject);
    }
}

}  // namespace walkcycle
