#pragma once

#include <string>
#include <vector>

#include "app/Arguments.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {

// Options that several verbs have. Each is declared here once, so that its name, help and meaning are the same
// everywhere. (The options of the loader, which all verbs with a document have, are in LoadArguments.h.)

// The positional FILE: a document, or - for standard input.
void declareDocument(Arguments& arguments, std::string& file);

// --clip, which findClip() of Clips.h looks up.
void declareClip(Arguments& arguments, std::string& clip);

// --time with several times, which documentTime() of Clips.h converts to times of the document.
void declareTimes(Arguments& arguments, std::vector<double>& times);

// --lights, --skeleton and --wireframe.
void declareLook(Arguments& arguments, RenderOptions& look);

}  // namespace walkcycle
