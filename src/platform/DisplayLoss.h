#pragma once

namespace walkcycle {

// Sets what is called when a window loses its display because the server was stopped or the connection cut.
// Xlib then ends the program with a message of its own, unless the handler ends it first. The handler must
// not use the display.
void whenDisplayIsLost(void (*handler)());

// Starts to watch for that. Call it once a display is open; it does nothing without X11.
void watchDisplay();

}  // namespace walkcycle
