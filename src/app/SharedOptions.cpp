#include "app/SharedOptions.h"

#include "app/Numbers.h"

namespace walkcycle {

void declareDocument(Arguments& arguments, std::string& file) {
    arguments.positional("FILE", "The document; - is standard input", file, Arguments::Need::Required);
}

void declareClip(Arguments& arguments, std::string& clip) {
    arguments.option("--clip", "NAME|N|all", "A clip, by name or number; `all` is the whole timeline", clip);
}

void declareTimes(Arguments& arguments, std::vector<double>& times) {
    arguments.option("--time,-t", "S[,S...]",
                     "Times in seconds on the document's timeline; with --clip, from the clip's start",
                     [&times](const std::string& text) { times = parseNumbers(text, "--time"); });
}

void declareLook(Arguments& arguments, RenderOptions& look) {
    arguments.choiceOf<Lighting>("--lights", {{"studio", Lighting::Studio}, {"file", Lighting::File}},
                                 "Lamps around the camera, or the document's own lights and materials",
                                 look.lights);
    arguments.flag("--skeleton", "Draw the joints on top", look.skeleton);
    arguments.flag("--wireframe", "Draw the edges on top", look.wireframe);
}

}  // namespace walkcycle
