#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "loaders/Inspection.h"

namespace walkcycle {

// Where a file is to be used. Each has rules of its own: what its reader leaves out, refuses or takes for something else.
enum class Profile { Gltf, Gazebo, SecondLife, ThinMatrix };

// What the command line calls them: "gltf", "gazebo", "secondlife", "thinmatrix".
std::span<const std::string_view> profileNames();
std::optional<Profile> profileNamed(std::string_view name);

// Looks at the document with the eyes of that target; what it finds is reported as WC10xx. To be called from
// LoadOptions::inspector:
//   options.inspector = [](const Inspection& inspection) { checkProfile(Profile::Gazebo, inspection); };
void checkProfile(Profile profile, const Inspection& inspection);

}  // namespace walkcycle
