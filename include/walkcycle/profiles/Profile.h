#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <walkcycle/Export.h>

namespace walkcycle {

struct Inspection;  // private: a document and its model at the end of a load

// A program or format for which a document can be checked. Each has rules about the elements that its importer skips,
// rejects or misreads; docs/checking.md lists them with their sources.
enum class Profile { Gltf, Gazebo, SecondLife, ThinMatrix };

// Their names, in the order of the enum: "gltf", "gazebo", "secondlife", "thinmatrix".
WALKCYCLE_API std::span<const std::string_view> profileNames();

// The profile of that name, in lower case; std::nullopt if there is none.
WALKCYCLE_API std::optional<Profile> profileNamed(std::string_view name);

// Checks a document against the rules of one profile, and adds a diagnostic (WC10xx) to Model::diagnostics for each
// fault. Call it from LoadOptions::inspector, once per profile:
//
//     options.inspector = [](const Inspection& inspection) { checkProfile(Profile::Gazebo, inspection); };
WALKCYCLE_API void checkProfile(Profile profile, const Inspection& inspection);

}  // namespace walkcycle
