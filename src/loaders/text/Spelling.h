#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// The word that was most likely meant, of those that are known (words between spaces): a letter or two apart, or in
// another case. Empty where none is near.
std::string_view nearest(std::string_view word, std::string_view known);

// The end of a message about an unknown word: "; perhaps 'NORMAL' is meant", or nothing.
std::string didYouMean(std::string_view word, std::string_view known);

// The one of `names` that differs from `name` in case alone (Windows and macOS do not tell them apart); empty if none.
std::string inAnotherCase(const std::vector<std::string>& names, const std::string& name);

}  // namespace walkcycle
