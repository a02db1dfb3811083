#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// The word of `known` (words separated by spaces) that `word` is most likely a misspelling of: a letter or two apart, or in
// another case. Empty if there is none.
std::string_view nearest(std::string_view word, std::string_view known);

// The end of a message about an unknown word: "; perhaps 'NORMAL' is meant", or nothing.
std::string didYouMean(std::string_view word, std::string_view known);

// The entry of `names` that equals `name` if case is ignored, as on Windows and macOS; empty if there is none.
std::string inAnotherCase(const std::vector<std::string>& names, const std::string& name);

}  // namespace walkcycle
