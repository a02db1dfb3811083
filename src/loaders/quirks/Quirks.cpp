#include "loaders/quirks/Quirks.h"

#include "loaders/text/Spelling.h"
#include "loaders/text/Words.h"

namespace walkcycle {

std::string unknownQuirk(std::string_view name) {
    std::string known;
    for (const QuirkInfo& info : kQuirks) known += std::string(info.name) + " ";
    return "there is no quirk '" + printable(name) + "'" + didYouMean(name, known);
}

}  // namespace walkcycle
