#include "walkcycle/loaders/LoadError.h"

#include <string_view>
#include <utility>

namespace walkcycle {

// The id of Code::Cancelled. (Diagnostics.h includes LoadError.h, so this file does not include it.)
constexpr std::string_view kCancelledCode = "WC0802";

LoadError::LoadError(std::vector<Diagnostic> all)
    : std::runtime_error(toString(all.back())), diagnostics(std::move(all)) {}

bool LoadError::cancelled() const {
    return reason().code == kCancelledCode;
}

}  // namespace walkcycle
