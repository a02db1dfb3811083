#pragma once

#include "profiles/Subject.h"

namespace walkcycle {

// The rules of each profile. The catalogue (DiagnosticCodes.inc, 10xx) and docs/checking.md say where each
// rule comes from.
void checkGltf(const Subject& subject);
void checkGazebo(const Subject& subject);
void checkSecondLife(const Subject& subject);
void checkThinMatrix(const Subject& subject);

// Parts of checkGazebo() and checkThinMatrix() that have files of their own.
void checkGazeboSkins(const Subject& subject);
void checkGazeboMotion(const Subject& subject);
void checkGazeboMaterials(const Subject& subject);
void checkThinMatrixMotion(const Subject& subject);

}  // namespace walkcycle
