#include <memory>

#include "app/CodeNames.h"
#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/Messages.h"
#include "loaders/Diagnostics.h"

namespace walkcycle {
namespace {

const char* word(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "info";
}

std::string explanation(const CodeInfo& entry) {
    return std::string(entry.id) + " " + entry.name + " (" + word(entry.severity) +
           ")\n  says:  " + entry.text + "\n  means: " + entry.cause + "\n  cure:  " + entry.cure + "\n";
}

int run(const std::string& wanted) {
    if (wanted.empty()) {
        std::string list;
        for (const CodeInfo& entry : diagnosticCatalogue())
            list += std::string(entry.id) + "  " + word(entry.severity) + "  " + entry.text + "\n";
        printOut(list);
        return kFine;
    }
    const CodeInfo* entry = codeNamed(wanted);
    if (!entry) throw UsageError("there is no message '" + wanted + "'; `walkcycle explain` alone lists all");
    printOut(explanation(*entry));
    return kFine;
}

}  // namespace

Command explainCommand() {
    const auto wanted = std::make_shared<std::string>();
    return {"explain", "What a message such as WC0207 means, and what to do about it",
            [wanted](Arguments& arguments) {
                arguments.positional("CODE", "The message's code; without one, all are listed", *wanted,
                                     Arguments::Need::Optional);
                arguments.examples("  walkcycle explain WC0207\n");
            },
            [wanted] { return run(*wanted); }};
}

}  // namespace walkcycle
