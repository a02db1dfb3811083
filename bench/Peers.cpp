#include "Peers.h"

#include <stdexcept>
#include <vector>

#ifdef WALKCYCLE_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#endif

#include "walkcycle/loaders/ColladaLoader.h"

void loadWithOpenCollada(const std::string& file);  // OpenCollada.cpp, where it is installed

namespace {

using namespace walkcycle;

// A model that can be drawn, but for its pictures: no other importer reads them.
void loadWithWalkcycle(const std::string& file) {
    LoadOptions options;
    options.loadImages = false;
    loadCollada(file, options);
}

#ifdef WALKCYCLE_ASSIMP
void readWithAssimp(const std::string& file, unsigned int steps) {
    Assimp::Importer importer;
    if (!importer.ReadFile(file, steps)) throw std::runtime_error(importer.GetErrorString());
}

void loadWithAssimp(const std::string& file) {
    readWithAssimp(file, 0);
}

// What a program needs before it can draw the model.
void loadAndJoinWithAssimp(const std::string& file) {
    readWithAssimp(file,
                   aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_LimitBoneWeights);
}
#endif

constexpr Importer kImporters[] = {
    {"walkcycle", loadWithWalkcycle},
#ifdef WALKCYCLE_ASSIMP
    {"assimp", loadWithAssimp},
    {"assimp-joined", loadAndJoinWithAssimp},
#endif
#ifdef WALKCYCLE_OPENCOLLADA
    {"opencollada", loadWithOpenCollada},
#endif
};

}  // namespace

std::span<const Importer> importers() {
    return kImporters;
}
