#pragma once

#include <cstddef>
#include <string>

namespace walkcycle {

// A pattern for the names of several pictures: "walk_{frame:04}.png" gives walk_0000.png, walk_0001.png, ...
class FramePattern {
public:
    // Throws UsageError if a {frame...} is not {frame} or {frame:digits}.
    explicit FramePattern(const std::string& pattern);

    // Without {frame}, the pattern is the name of a single picture.
    bool hasFrame() const { return hasFrame_; }
    std::string name(int frame) const;

private:
    std::string before_, after_;
    bool hasFrame_ = false;
    std::size_t digits_ = 1;
};

}  // namespace walkcycle
