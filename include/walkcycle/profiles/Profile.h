#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <walkcycle/Export.h>

namespace walkcycle {

struct Inspection;

// A program or format that a document is checked for. Each has rules: what its importer skips, rejects or misreads.
enum class Profile { Gltf, Gazebo, SecondLife, ThinMatrix };

// Their names, in the order of the enum: "gltf", "gazebo", "secondlife", "thinmatrix".
WALKCYCLE_API std::span<const std::string_view> profileNames();
// The profile of that name; nothing if there is none.
WALKCYCLE_API std::optional<Profile> profileNamed(std::string_view name);

// Checks a document against the rules of one profile, and reports each breach as WC10xx. Call it from
// LoadOptions::inspector:
//   options.inspector = [](const Inspection& inspection) { checkProfile(Profile::Gazebo, inspection); };
WALKCYCLE_API void checkProfile(Profile profile, const Inspection& inspection);

}  // namespace walkcycle
