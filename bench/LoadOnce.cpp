// Loads a file once, for what counts a whole process (memory, instructions) and prints nothing:
//   bench_once IMPORTER FILE      bench_once (alone: which importers there are)

#include <cstdio>
#include <exception>
#include <string_view>

#include "Peers.h"

int main(int count, char** arguments) {
    if (count < 3) {
        for (const Importer& importer : importers()) std::puts(importer.name);
        return 0;
    }
    for (const Importer& importer : importers()) {
        if (std::string_view(arguments[1]) != importer.name) continue;
        try {
            importer.load(arguments[2]);
            return 0;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
            return 1;
        }
    }
    std::fprintf(stderr, "bench_once: no importer '%s' was installed when this was built\n", arguments[1]);
    return 2;
}
