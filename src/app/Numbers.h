#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace walkcycle {

// Parse the values of options, the same under every locale. They throw a UsageError if the text is wrong; its message
// begins with `option` and says what is expected.
double parseNumber(std::string_view text, const std::string& option);
int parseInteger(std::string_view text, const std::string& option, int least, int most);
std::uint64_t parseSize(std::string_view text, const std::string& option);  // 1500, 20k, 64M, 2G (of 1024)
std::vector<double> parseNumbers(std::string_view text, const std::string& option);  // "0,0.5,1"
glm::vec3 parseVector(std::string_view text, const std::string& option);             // "X,Y,Z"
std::pair<int, int> parsePair(std::string_view text, char separator, const std::string& option, int most);
glm::vec3 parseColor(std::string_view text, const std::string& option);  // "#rrggbb" or "#rgb", 0 to 1

}  // namespace walkcycle
