#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// The one place that parses numbers. The locale does not matter, and a token must be a number as a whole: "1.5x", "0x10",
// "1,5", "--1" and "1e400" are faults; "+1", ".5", "1.", denormals (rounded) and any XML white space are fine. INF, -INF
// and NaN, which xs:float allows, are faults, too; the caller decides how to report them.

// A token that is not a usable number.
struct NumberFault {
    std::size_t index = 0;   // of the number in the list
    std::size_t offset = 0;  // of the token in the text
    std::string_view token;
};

// Called after each piece of a text is parsed, with the piece's length; the lengths sum up to that of the text. A piece
// takes a few milliseconds. An exception of the callback ends the parsing.
using PieceRead = std::function<void(std::size_t characters)>;

// Parses numbers separated by white space, and appends them to `values`. For a faulty token it appends 0, and adds the
// fault to `faults` unless there are kMaxFaults already.
void parseNumbers(std::string_view text, std::vector<float>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead = {});
void parseNumbers(std::string_view text, std::vector<double>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead = {});
void parseNumbers(std::string_view text, std::vector<std::int32_t>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead = {});
inline constexpr std::size_t kMaxFaults = 16;

// A faulty token with some tokens before and after it, so that it can be found in a long line: "... 0 1 1,5 3 4 ...".
// Empty if it is the only token.
std::string surroundings(std::string_view text, const NumberFault& fault);

// Parses a text that holds one number, and white space around it at most. Returns false if it does not, or if the number
// is not finite or out of range.
bool parseNumber(std::string_view text, double& value);
bool parseNumber(std::string_view text, std::int32_t& value);
bool parseUnsigned(std::string_view text, std::uint64_t& value);  // a count

}  // namespace walkcycle
