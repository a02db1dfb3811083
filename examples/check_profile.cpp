// What Gazebo makes of a file: a load with the rules of a profile. Exit code 1 if Gazebo loses something of the file.
#include <algorithm>
#include <cstdio>

#include <walkcycle/loaders/ColladaLoader.h>
#include <walkcycle/profiles/Profile.h>

using namespace walkcycle;

int main(int argc, char** argv) try {
    LoadOptions options;
    options.inspector = [](const Inspection& inspection) { checkProfile(Profile::Gazebo, inspection); };
    const Model model = loadCollada(argc > 1 ? argv[1] : "res/walker.dae", options);
    for (const Diagnostic& diagnostic : model.diagnostics) std::printf("%s\n", toString(diagnostic).c_str());
    return std::any_of(model.diagnostics.begin(), model.diagnostics.end(),
                       [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
} catch (const LoadError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
