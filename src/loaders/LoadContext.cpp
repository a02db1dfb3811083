#include "loaders/LoadContext.h"

#include "loaders/LimitCheck.h"

namespace walkcycle {

void LoadContext::require(std::uint64_t amount, std::uint64_t LoadLimits::*limit,
                          const XmlNode& where) const {
    requireWithin(options.limits, limit, amount, where, diagnostics);
}

void LoadContext::checkCancelled(const XmlNode& where) const {
    if (options.cancelled && options.cancelled()) diagnostics.fail(Code::Cancelled, where, {});
}

}  // namespace walkcycle
