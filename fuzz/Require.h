#pragma once

#include <cstdio>
#include <cstdlib>

// A promise that every input must keep. It is no assert: it also holds in Release builds, where ctest replays the inputs.
#define REQUIRE(promise)                                                                       \
    do {                                                                                       \
        if (!(promise)) {                                                                      \
            std::fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE__, __LINE__, #promise); \
            std::abort();                                                                      \
        }                                                                                      \
    } while (false)
