#include "app/FramePattern.h"

#include <cstddef>

#include "app/ExitCode.h"
#include "app/Numbers.h"

namespace walkcycle {
namespace {

constexpr int kMostDigits = 20;

}  // namespace

FramePattern::FramePattern(const std::string& pattern) : before_(pattern) {
    constexpr std::size_t kWordLength = 6;  // the length of "{frame"
    const std::size_t start = pattern.find("{frame");
    if (start == std::string::npos) return;
    const std::size_t end = pattern.find('}', start);
    const std::size_t width = start + kWordLength;
    if (end == std::string::npos || (end != width && pattern[width] != ':'))
        throw UsageError("--output: '" + pattern + "': write {frame} or {frame:04}");
    if (end != width)
        digits_ = static_cast<std::size_t>(parseInteger(pattern.substr(width + 1, end - width - 1),
                                                        "--output: {frame:digits}", 1, kMostDigits));
    hasFrame_ = true;
    before_ = pattern.substr(0, start);
    after_ = pattern.substr(end + 1);
}

std::string FramePattern::name(int frame) const {
    if (!hasFrame_) return before_;
    std::string number = std::to_string(frame);
    if (number.size() < digits_) number.insert(0, digits_ - number.size(), '0');
    return before_ + number + after_;
}

}  // namespace walkcycle
