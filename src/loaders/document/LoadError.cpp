#include "walkcycle/loaders/LoadError.h"

#include <string_view>
#include <utility>

namespace walkcycle {

// Code::Cancelled of the catalogue, which stands above this file.
constexpr std::string_view kCancelledCode = "WC0802";

LoadError::LoadError(std::vector<Diagnostic> all)
    : std::runtime_error(toString(all.back())), diagnostics(std::move(all)) {}

bool LoadError::cancelled() const {
    return reason().code == kCancelledCode;
}

}  // namespace walkcycle
