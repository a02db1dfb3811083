#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace walkcycle {

// Numbers as people type them in options, the same under any locale. `option` is named in the UsageError that
// says why a text is none.
double parseNumber(std::string_view text, const std::string& option);
int parseInteger(std::string_view text, const std::string& option, int least, int most);
std::uint64_t parseSize(std::string_view text, const std::string& option);  // 1500, 20k, 64M, 2G (of 1024)
std::vector<double> parseNumbers(std::string_view text, const std::string& option);  // "0,0.5,1"
glm::vec3 parseVector(std::string_view text, const std::string& option);             // "X,Y,Z"
std::pair<int, int> parsePair(std::string_view text, char separator, const std::string& option, int most);
glm::vec3 parseColor(std::string_view text, const std::string& option);  // "#rrggbb" or "#rgb", 0 to 1

// The shortest text that reads back as the same number, or with `digits` after the point.
std::string formatNumber(double number);
std::string formatFixed(double number, int digits);
std::string formatScientific(double number);  // "2.3e-05"

}  // namespace walkcycle
