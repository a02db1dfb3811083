#pragma once

// Marks what a shared library shows to its users. Everything else is hidden, and may change at will.
#define WALKCYCLE_API __attribute__((visibility("default")))
