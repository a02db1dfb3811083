#include "loaders/LoadContext.h"

namespace walkcycle {

void LoadContext::require(std::uint64_t amount, std::uint64_t limit, const char* what,
                          const XmlNode& where) const {
    if (amount > limit)
        diagnostics.fail(Code::LimitExceeded, where, {what, std::to_string(amount), std::to_string(limit)});
}

void LoadContext::checkCancelled(const XmlNode& where) const {
    if (options.cancelled && options.cancelled()) diagnostics.fail(Code::Cancelled, where, {});
}

}  // namespace walkcycle
