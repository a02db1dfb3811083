#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace walkcycle {

struct Inspection;

// Where a file is to be used. Each has rules of its own: what its reader leaves out, refuses or takes for something else.
enum class Profile { Gltf, Gazebo, SecondLife, ThinMatrix };

// Their names, in the order of the enum: "gltf", "gazebo", "secondlife", "thinmatrix".
std::span<const std::string_view> profileNames();
// The profile of that name; nothing where there is none.
std::optional<Profile> profileNamed(std::string_view name);

// Looks at the document with the eyes of that target; what it finds is reported as WC10xx. To be called from
// LoadOptions::inspector:
//   options.inspector = [](const Inspection& inspection) { checkProfile(Profile::Gazebo, inspection); };
void checkProfile(Profile profile, const Inspection& inspection);

}  // namespace walkcycle
