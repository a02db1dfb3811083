#include "walkcycle/profiles/Profile.h"

#include <array>
#include <cassert>
#include <cstddef>

#include "profiles/Rules.h"

namespace walkcycle {
namespace {

struct Row {
    Profile profile;
    std::string_view name;  // for profileNamed() and `check --profile`
    void (*check)(const Subject&);
};

constexpr std::array kProfiles = {
    Row{Profile::Gltf, "gltf", checkGltf},
    Row{Profile::Gazebo, "gazebo", checkGazebo},
    Row{Profile::SecondLife, "secondlife", checkSecondLife},
    Row{Profile::ThinMatrix, "thinmatrix", checkThinMatrix},
};

constexpr auto kNames = [] {
    std::array<std::string_view, kProfiles.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kProfiles[i].name;
    return names;
}();

}  // namespace

std::span<const std::string_view> profileNames() {
    return kNames;
}

std::optional<Profile> profileNamed(std::string_view name) {
    for (const Row& row : kProfiles)
        if (row.name == name) return row.profile;
    return std::nullopt;
}

void checkProfile(Profile profile, const Inspection& inspection) {
    const Subject subject(inspection);
    for (const Row& row : kProfiles)
        if (row.profile == profile) return row.check(subject);
    assert(false && "a profile without a row");
}

}  // namespace walkcycle
