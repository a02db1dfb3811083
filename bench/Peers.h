#pragma once

#include <span>
#include <string>

// Programs' libraries that read the same files, each where it was installed when this was built. Ours is the first.
struct Importer {
    const char* name;
    void (*load)(const std::string& file);  // and forgets it; throws std::runtime_error where that fails
};
std::span<const Importer> importers();
