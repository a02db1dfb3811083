#pragma once

namespace walkcycle {

// Sets the function to call when the connection to the X server breaks. After the call Xlib ends the program with a
// message of its own, so a handler that wants another message or exit code ends the program itself. The handler must
// not use the display.
void whenDisplayIsLost(void (*handler)());

// Installs that handler in Xlib. Call it after a display was opened; without X11 it does nothing.
void watchDisplay();

}  // namespace walkcycle
