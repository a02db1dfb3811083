#include "QuirksPage.h"

#include <algorithm>
#include <cstddef>

#include "loaders/quirks/Quirks.h"

namespace walkcycle::house {
namespace {

const std::string kHeading = "## Quirks of exporters\n";

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

std::string entry(const QuirkInfo& quirk) {
    const std::string name(quirk.name), tools = toolsOf(quirk);
    return "- **`" + name + "`.** " + escaped(quirk.rule) + " *For:* " +
           (tools.empty() ? "any file that shows it." : tools + ".") + " *Evidence:* " +
           escaped(quirk.evidence) +
           (quirk.code.empty() ? "" : " *Said as* " + std::string(quirk.code) + ".") +
           " *Fixture:* `tests/fixtures/quirks/" + name + ".dae`.\n";
}

}  // namespace

std::string quirksSection() {
    std::string section = kHeading +
                          "\nWhat exporters mean that the specification does not say, or says otherwise. A "
                          "document's *dialect* is the "
                          "tool and version in the `<authoring_tool>` of its `<asset>`; each document of a "
                          "load has its own. It decides "
                          "which quirks are on, and `--quirk NAME=on|off` (in the library "
                          "`LoadOptions::quirks`) decides before it. "
                          "`info --verbose` lists them for a file, and which of them are used there.\n\n"
                          "This section is made from `src/loaders/quirks/Quirks.h`; do not edit it. "
                          "`tests/loaders/quirks/QuirksTest.cpp` reads each "
                          "fixture with its quirk and without it.\n\n";
    for (const QuirkInfo& quirk : kQuirks) section += entry(quirk);
    return section;
}

std::string withQuirksSection(const std::string& page) {
    const std::size_t begin = std::min(page.find(kHeading), page.size());
    const std::size_t next = page.find("\n## ", begin);
    const std::string rest = next == std::string::npos ? "" : page.substr(next);
    return page.substr(0, begin) + quirksSection() + rest;
}

}  // namespace walkcycle::house
