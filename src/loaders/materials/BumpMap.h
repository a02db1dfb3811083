#pragma once

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Whether a bump picture holds heights: those are grey, while normals are bluish.
bool holdsHeights(const Image& image);

// The normals of a surface with these heights, as colours: red and green are where it leans to the right and up, blue
// is how much it faces us; 128 is none. The format does not say how high white is: four texels, here.
Image normalsOfHeights(const Image& heights);

}  // namespace walkcycle
