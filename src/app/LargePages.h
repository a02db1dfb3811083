#pragma once

namespace walkcycle {

// Makes the heap one stretch of large pages to begin with, which keeps what is given back. A picture takes some 50 MB
// of memory, most of it inside the graphics driver and only once; in pages of 4 KB getting it costs more than drawing
// does. Does nothing where the system has no such thing, or allows too little. To be called first of all.
void useLargePages();

}  // namespace walkcycle
