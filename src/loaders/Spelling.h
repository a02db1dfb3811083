#pragma once

#include <string>
#include <string_view>

namespace walkcycle {

// The word that was most likely meant, of those that are known (words between spaces): a letter or two apart, or in
// another case. Empty where none is near.
std::string_view nearest(std::string_view word, std::string_view known);

// The end of a message about an unknown word: "; perhaps 'NORMAL' is meant", or nothing.
std::string didYouMean(std::string_view word, std::string_view known);

}  // namespace walkcycle
