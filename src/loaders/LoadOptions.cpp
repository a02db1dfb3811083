#include "walkcycle/loaders/LoadOptions.h"

#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>

#include "loaders/quirks/Quirks.h"

namespace walkcycle {
namespace {

std::string toText(double number) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << number;
    return text.str();
}

}  // namespace

InvalidOption::InvalidOption(const std::string& nameOfOption, const std::string& value,
                             const std::string& whatItMustBe)
    : std::invalid_argument("LoadOptions::" + nameOfOption + " is " + value + "; it " + whatItMustBe),
      option(nameOfOption),
      must(whatItMustBe) {}

void requireValid(const LoadOptions& options) {
    if (!(options.tolerance > 0.0) || std::isinf(options.tolerance))
        throw InvalidOption("tolerance", toText(options.tolerance), "must be a number over 0");
    const double unit = options.metersPerUnit.value_or(1.0);
    if (!isUsableUnit(unit))
        throw InvalidOption("metersPerUnit", toText(unit), "must be a number from 1e-12 to 1e12");
    for (const LimitInfo& limit : kLimits) {
        const std::uint64_t value = options.limits.*limit.value;
        if (value > limit.most)
            throw InvalidOption("limits." + std::string(limit.name), std::to_string(value),
                                "can be at most " + std::to_string(limit.most));
    }
    for (const auto& [name, on] : options.quirks)
        if (!findQuirk(name))
            throw InvalidOption("quirks", "{" + name + (on ? ": on}" : ": off}"),
                                "must name quirks that exist: " + unknownQuirk(name));
}

}  // namespace walkcycle
