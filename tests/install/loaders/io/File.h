#pragma once

// A header of the user, who has names of his own.
constexpr int kMyFile = 1;
