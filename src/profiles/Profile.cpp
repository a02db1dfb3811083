#include "profiles/Profile.h"

#include <array>
#include <cassert>

#include "profiles/Rules.h"

namespace walkcycle {
namespace {

struct Row {
    Profile profile;
    std::string_view name;  // on the command line
    void (*check)(const Subject&);
};

constexpr std::array kProfiles = {
    Row{Profile::Gltf, "gltf", checkGltf},
    Row{Profile::Gazebo, "gazebo", checkGazebo},
    Row{Profile::SecondLife, "secondlife", checkSecondLife},
    Row{Profile::ThinMatrix, "thinmatrix", checkThinMatrix},
};

}  // namespace

std::vector<std::string> profileNames() {
    std::vector<std::string> names;
    for (const Row& row : kProfiles) names.emplace_back(row.name);
    return names;
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
