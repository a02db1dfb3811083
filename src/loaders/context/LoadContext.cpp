#include "loaders/context/LoadContext.h"

#include <cstddef>

#include "loaders/document/LimitCheck.h"
#include "loaders/document/LoadProgress.h"

namespace walkcycle {

void LoadContext::require(std::uint64_t amount, std::uint64_t LoadLimits::*limit,
                          const XmlNode& where) const {
    requireWithin(options.limits, limit, amount, where, diagnostics);
}

void LoadContext::checkCancelled(const XmlNode& where) const {
    if (options.cancelled && options.cancelled()) diagnostics.fail(Code::Cancelled, where, {});
}

void LoadContext::advance(double work) const {
    if (progress) progress->advance(work);
}

PieceRead LoadContext::pieceRead() const {
    if (!progress) return {};
    return [to = progress](std::size_t characters) { to->advance(static_cast<double>(characters)); };
}

}  // namespace walkcycle
