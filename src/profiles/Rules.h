#pragma once

#include "profiles/Subject.h"

namespace walkcycle {

// The rules of one target each. Where they come from stands in the catalogue (DiagnosticCodes.inc, 10xx) and in
// docs/checking.md.
void checkGltf(const Subject& subject);
void checkGazebo(const Subject& subject);
void checkGazeboSkins(const Subject& subject);      // its part about skins and morphs
void checkGazeboMotion(const Subject& subject);     // its part about animations
void checkGazeboMaterials(const Subject& subject);  // its part about materials
void checkSecondLife(const Subject& subject);
void checkThinMatrix(const Subject& subject);
void checkThinMatrixMotion(const Subject& subject);  // its part about joints and animations

}  // namespace walkcycle
