#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/CheckReport.h"
#include "app/CodeNames.h"
#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/Joined.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "loaders/document/Diagnostics.h"
#include "walkcycle/io/File.h"
#include "walkcycle/profiles/Profile.h"

namespace walkcycle {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    LoadArguments load;
    std::vector<std::string> files, ignored, profiles;
    bool json = false, warningsFail = false;
};

void declare(CheckOptions& options, Arguments& arguments) {
    arguments.positionals("FILE", "Documents, or folders of documents; - is standard input", options.files);
    arguments.options("--profile", joined(profileNames(), "|"),
                      "Also report what this program or format skips or misreads; may be repeated",
                      options.profiles);
    arguments.flag("--json", "Print JSON, with the glTF validator's field names", options.json);
    arguments.choiceOf<bool>("--fail-on", {{"error", false}, {"warning", true}},
                             "The least severity for which the exit code is 1 (error)", options.warningsFail);
    arguments.options("--ignore", "CODE", "Neither show nor count messages of this code; may be repeated",
                      options.ignored);
    options.load.declare(arguments);
    arguments.examples(
        "  walkcycle check hero.dae                    what is wrong, with the line and a way to fix it\n"
        "  walkcycle check hero.dae --profile gazebo   and what Gazebo makes of it\n"
        "  walkcycle check exports/ --strict --quiet   for a build: exit code 1 for any warning\n"
        "  walkcycle explain WC0401                    more about one message\n");
}

bool isDocument(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".dae" || extension == ".zae";
}

// The documents in a folder and in all folders below it, sorted by path. Throws UsageError if there are none.
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

// The files to check. A folder that cannot be read is reported and noted, and the others are checked.
struct Work {
    std::vector<std::string> files;
    bool several = false;     // the command line names more than one file, or a folder
    bool unreadable = false;  // a folder could not be read
};

Work workOf(const std::vector<std::string>& names) {
    Work work;
    work.several = names.size() > 1;
    std::error_code ignored;
    for (const std::string& name : names) {
        if (!fs::is_directory(name, ignored)) {
            work.files.push_back(name);
            continue;
        }
        work.several = true;
        try {
            const std::vector<std::string> inside = documentsIn(name);
            work.files.insert(work.files.end(), inside.begin(), inside.end());
        } catch (const UsageError& error) {
            printError(error.what());
            work.unreadable = true;
        }
    }
    return work;
}

std::vector<Profile> profilesOf(const std::vector<std::string>& names) {
    std::vector<Profile> profiles;
    for (const std::string& name : names) {
        const std::optional<Profile> profile = profileNamed(name);
        if (!profile)
            throw UsageError("--profile: '" + name + "' is none of " + joined(profileNames(), ", "));
        if (std::find(profiles.begin(), profiles.end(), *profile) == profiles.end())
            profiles.push_back(*profile);
    }
    return profiles;
}

std::vector<std::string> ignoredCodes(const std::vector<std::string>& names) {
    std::vector<std::string> codes;
    for (const std::string& name : names) {
        const CodeInfo* entry = codeNamed(name);
        if (!entry)
            throw UsageError("--ignore: there is no message '" + name + "'; `walkcycle explain` lists all");
        codes.emplace_back(entry->id);
    }
    return codes;
}

// Adds a diagnostic about a file that could not be read, if the loader gave none.
void addFailure(CheckReport& report, const std::string& reason) {
    Diagnostic diagnostic;
    diagnostic.code = info(Code::FileUnreadable).id;
    diagnostic.file = report.file;
    diagnostic.message = reason;
    diagnostic.cure = info(Code::FileUnreadable).cure;
    report.diagnostics.push_back(std::move(diagnostic));
    report.readable = false;
}

CheckReport check(const LoadArguments& load, const std::string& file) {
    CheckReport report;
    report.file = file;
    try {
        Model model = load.loadSilently(file);
        report.loaded = true;
        report.version = model.asset.version;
        report.authoringTool = model.asset.authoringTool;
        report.facts = factsOf(model);
        report.diagnostics = std::move(model.diagnostics);
    } catch (const LoadError& error) {
        report.diagnostics = error.diagnostics;
        report.readable =
            error.diagnostics.empty() || error.diagnostics.back().code != info(Code::FileUnreadable).id;
    } catch (const FileError& error) {
        addFailure(report, error.what());
    } catch (const std::bad_alloc&) {
        addFailure(report, "there is not enough memory for it");
    }
    return report;
}

// Removes the diagnostics that have one of these codes.
void leaveOut(std::vector<Diagnostic>& diagnostics, const std::vector<std::string>& codes) {
    std::erase_if(diagnostics, [&](const Diagnostic& diagnostic) {
        return std::find(codes.begin(), codes.end(), diagnostic.code) != codes.end();
    });
}

bool hasFailed(const CheckReport& report, bool warningsFail) {
    const DiagnosticCounts counts = count(report.diagnostics);
    return !report.loaded || counts.errors > 0 || (warningsFail && counts.warnings > 0);
}

// Checks the files one after the other, and prints the messages about each before the next is loaded.
std::vector<CheckReport> checkAll(const CheckOptions& options, const Work& work) {
    const std::vector<std::string> ignored = ignoredCodes(options.ignored);
    const std::vector<Profile> profiles = profilesOf(options.profiles);
    LoadArguments load = options.load;
    if (!profiles.empty())
        load.options.inspector = [&profiles](const Inspection& inspection) {
            for (const Profile profile : profiles) checkProfile(profile, inspection);
        };
    Progress progress("checking", !options.load.quiet);
    std::vector<CheckReport> reports;
    const auto update = [&](double share) {
        progress.update((static_cast<double>(reports.size()) + share) /
                        static_cast<double>(work.files.size()));
    };
    if (progress.isShown()) load.options.progress = update;
    for (const std::string& file : work.files) {
        CheckReport report = check(load, file);
        leaveOut(report.diagnostics, ignored);
        report.profiles = options.profiles;
        if (!options.json) {
            progress.clear();
            printDiagnostics(report.diagnostics, options.load.quiet ? Severity::Error : Severity::Info);
            printOut(summary(report));
        }
        reports.push_back(std::move(report));
    }
    return reports;
}

int run(const CheckOptions& options) {
    const Work work = workOf(options.files);
    const std::vector<CheckReport> reports = checkAll(options, work);
    if (options.json && (work.several || !reports.empty()))
        printOut(reportsJson(reports, work.several));
    else if (!options.json && reports.size() > 1)
        printOut(total(reports));
    const bool warningsFail = options.load.strict || options.warningsFail;
    bool unreadable = work.unreadable, failed = false;
    for (const CheckReport& report : reports) {
        unreadable |= !report.readable;
        failed |= hasFailed(report, warningsFail);
    }
    return unreadable ? kWrongUsage : failed ? kFaultsFound : kFine;
}

}  // namespace

Command checkCommand() {
    const auto options = std::make_shared<CheckOptions>();
    return {"What is wrong with files, where, and how to fix it",
            [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
