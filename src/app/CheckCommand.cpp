#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

#include "app/CheckReport.h"
#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "loaders/Diagnostics.h"

namespace walkcycle {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    LoadArguments load;
    std::vector<std::string> files, ignored;
    std::string failOn = "error";
    bool json = false;
};

void declare(CheckOptions& options, Arguments& arguments) {
    arguments.positionals("FILE", "Documents, or folders that hold some; - is standard input", options.files);
    arguments.flag("--json", "Print JSON, with the glTF validator's field names", options.json);
    arguments.choice("--fail-on", {"error", "warning"}, "From which severity on the exit code is 1",
                     options.failOn);
    arguments.options("--ignore", "CODE", "Leave out messages of this code", options.ignored);
    options.load.declare(arguments);
    arguments.examples(
        "  walkcycle check hero.dae                    what is wrong, each with its line and its cure\n"
        "  walkcycle check exports/ --strict --quiet   for a build: exit code 1 where anything is\n"
        "  walkcycle explain WC0401                    more about one message\n");
}

bool isDocument(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".dae" || extension == ".zae";
}

// The documents of a folder and of those below it, in the order of their names.
std::vector<std::string> documentsIn(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code error;
    auto entry =
        fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        if (isDocument(entry->path()) && entry->is_regular_file(error))
            files.push_back(entry->path().string());
    if (error) throw UsageError("cannot read the folder '" + folder + "': " + error.message());
    if (files.empty()) throw UsageError("the folder '" + folder + "' holds no .dae or .zae");
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> allFiles(const CheckOptions& options) {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const std::string& name : options.files) {
        if (!fs::is_directory(name, ignored)) {
            files.push_back(name);
            continue;
        }
        const std::vector<std::string> inside = documentsIn(name);
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

CheckReport check(const CheckOptions& options, const std::string& file) {
    CheckReport report;
    report.file = file;
    try {
        Model model = options.load.loadSilently(file);
        report.loaded = true;
        report.version = model.asset.version;
        report.authoringTool = model.asset.authoringTool;
        report.facts = factsOf(model);
        report.diagnostics = std::move(model.diagnostics);
    } catch (const LoadError& error) {
        report.diagnostics = error.diagnostics;
        report.readable =
            error.diagnostics.empty() || error.diagnostics.back().code != info(Code::FileUnreadable).id;
    }
    std::erase_if(report.diagnostics, [&](const Diagnostic& diagnostic) {
        return std::find(options.ignored.begin(), options.ignored.end(), diagnostic.code) !=
               options.ignored.end();
    });
    return report;
}

std::string summary(const CheckReport& report) {
    const DiagnosticCounts counts = count(report.diagnostics);
    const auto number = [](int n, const char* word) {
        return std::to_string(n) + " " + word + (n == 1 ? "" : "s");
    };
    std::string line = report.file + ": ";
    if (counts.errors + counts.warnings + counts.infos == 0)
        return line + (report.loaded ? "fine\n" : "nothing to show\n");
    line += number(counts.errors, "error") + ", " + number(counts.warnings, "warning") + ", " +
            number(counts.infos, "note");
    return line + (report.loaded ? "\n" : "; nothing can be shown\n");
}

int run(const CheckOptions& options) {
    const bool warningsFail = options.load.strict || options.failOn == "warning";
    std::vector<CheckReport> reports;
    bool unreadable = false, failed = false;
    for (const std::string& file : allFiles(options)) {
        CheckReport report = check(options, file);
        const DiagnosticCounts counts = count(report.diagnostics);
        unreadable |= !report.readable;
        failed |= !report.loaded || counts.errors > 0 || (warningsFail && counts.warnings > 0);
        if (!options.json) {
            printDiagnostics(report.diagnostics, options.load.quiet ? Severity::Error : Severity::Info);
            printOut(summary(report));
        } else {
            reports.push_back(std::move(report));
        }
    }
    if (options.json) printOut(reportsJson(reports));
    return unreadable ? kWrongUsage : failed ? kFaultsFound : kFine;
}

}  // namespace

Command checkCommand() {
    const auto options = std::make_shared<CheckOptions>();
    return {"check", "What is wrong with files, where, and how to mend it",
            [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
