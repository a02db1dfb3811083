#pragma once

namespace walkcycle {

// What to do when a window's display goes away: its server was stopped, or the connection cut. Xlib then ends the
// program with a message of its own unless the handler, which may do no more with the display, ends it first.
void whenDisplayIsLost(void (*handler)());

// To be called when there is a display; does nothing where it is not X11's.
void watchDisplay();

}  // namespace walkcycle
