#pragma once

#include <string>

namespace walkcycle {

// Numbers as text, the same under every locale.

std::string formatNumber(double number);             // the shortest text that reads back as the same number
std::string formatFixed(double number, int digits);  // with `digits` digits after the point
std::string formatScientific(double number);         // "2.3e-05"

}  // namespace walkcycle
