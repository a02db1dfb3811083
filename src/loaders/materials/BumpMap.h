#pragma once

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Whether a bump picture holds heights. Heights are grey; pictures of normals are bluish.
bool holdsHeights(const Image& image);

// Converts heights to tangent-space normals, stored as colours: red and green are the slopes to the right and
// up, blue is the part towards the viewer; 128 is 0. The format does not say how high white is; four texels
// here.
Image normalsOfHeights(const Image& heights);

}  // namespace walkcycle
