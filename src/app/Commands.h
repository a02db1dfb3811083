#pragma once

#include <vector>

#include "app/Arguments.h"

namespace walkcycle {

// One per verb, each in a file of its own.
Command checkCommand();
Command compareCommand();
Command explainCommand();
Command infoCommand();
Command poseCommand();
Command renderCommand();
Command viewCommand();

// The version of the program, of the libraries, and the OpenGL that there is.
std::string versionText();

}  // namespace walkcycle
