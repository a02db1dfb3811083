#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// The one place where text becomes numbers. Locale-free, whole tokens only: "1.5x", "0x10", "1,5", "--1" and "1e400"
// are faults; "+1", ".5", "1.", denormals (rounded) and any XML white space are fine. INF, -INF and NaN, which xs:float
// allows, are faults too: what the loader does about them is the caller's choice.
struct NumberFault {
    std::size_t index = 0;   // which number of the list
    std::size_t offset = 0;  // where in the text its token starts
    std::string_view token;
};

// Told of each piece of a text that was read, of so many characters: all of them together once the text is read. A piece
// takes a few milliseconds. What it throws ends the reading.
using PieceRead = std::function<void(std::size_t characters)>;

// Parses white-space separated numbers until the text ends, appending to `values` (a faulty token appends 0, and its
// fault to `faults`, the first kMaxFaults of them).
void parseNumbers(std::string_view text, std::vector<float>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead = {});
void parseNumbers(std::string_view text, std::vector<double>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead = {});
void parseNumbers(std::string_view text, std::vector<std::int32_t>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead = {});
inline constexpr std::size_t kMaxFaults = 16;

// A faulty token with the few before and after it, so that it can be found in a long line: "... 0 1 1,5 3 4 ...".
// Empty where it stands alone.
std::string surroundings(std::string_view text, const NumberFault& fault);

// One number and nothing else but white space around it. False where it is not one (or not finite).
bool parseNumber(std::string_view text, double& value);
bool parseNumber(std::string_view text, std::int32_t& value);
bool parseUnsigned(std::string_view text, std::uint64_t& value);  // a count

}  // namespace walkcycle
