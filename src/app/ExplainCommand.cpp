#include <memory>
#include <string>

#include "app/CodeNames.h"
#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/Messages.h"
#include "app/OptionHints.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/MessageTemplate.h"

namespace walkcycle {
namespace {

// The page about one message. Words in capitals (NAME, COUNT) stand for the parts that a message takes from the file.
std::string explanation(const CodeInfo& entry) {
    std::string text = std::string(entry.id) + " " + entry.name + " (" + nameOf(entry.severity) +
                       ")\n  says:  " + withWords(entry.text) + "\n  means: " + entry.cause +
                       "\n  cure:  " + withOption(entry.id, withWords(entry.cure)) + "\n";
    if (!*entry.inBlender) return text;
    return text + "    Blender: " + entry.inBlender + "\n    Maya:    " + entry.inMaya +
           "\n    3ds Max: " + entry.in3dsMax + "\n";
}

int run(const std::string& wanted) {
    if (wanted.empty()) {
        std::string list;
        for (const CodeInfo& entry : diagnosticCatalogue())
            list +=
                std::string(entry.id) + "  " + nameOf(entry.severity) + "  " + withWords(entry.text) + "\n";
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
    return {"What a message such as WC0207 means, and what to do about it",
            [wanted](Arguments& arguments) {
                arguments.positional("CODE", "The code of a message; without one, all messages are listed",
                                     *wanted, Arguments::Need::Optional);
                arguments.examples("  walkcycle explain WC0207\n");
            },
            [wanted] { return run(*wanted); }};
}

}  // namespace walkcycle
