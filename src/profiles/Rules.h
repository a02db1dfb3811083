#pragma once

#include "profiles/Subject.h"

namespace walkcycle {

// Each function checks a document against all rules of one profile, and reports the faults. The catalogue
// (DiagnosticCodes.inc, 10xx) and docs/checking.md name the source of each rule.
void checkGltf(const Subject& subject);
void checkGazebo(const Subject& subject);
void checkSecondLife(const Subject& subject);
void checkThinMatrix(const Subject& subject);

// Parts of checkGazebo() and checkThinMatrix(), each in a file of its own.
void checkGazeboSkins(const Subject& subject);
void checkGazeboMotion(const Subject& subject);
void checkGazeboMaterials(const Subject& subject);
void checkThinMatrixMotion(const Subject& subject);

}  // namespace walkcycle
