#include "app/Program.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <new>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "io/File.h"
#include "io/Image.h"
#include "loaders/Diagnostics.h"
#include "platform/NoGraphicsDevice.h"

namespace walkcycle {
namespace {

constexpr const char* kAbout =
    "Walkcycle opens COLLADA characters (.dae, .zae), plays their walk cycle right, says what is wrong with "
    "the file, and "
    "renders.";
constexpr const char* kExamples =
    "A bare FILE means `view`; without one, the built-in character walks.\n"
    "\nExamples:\n"
    "  walkcycle                                 the built-in character, in a window\n"
    "  walkcycle hero.dae                        yours\n"
    "  walkcycle render hero.dae -o hero.png     a picture, without a display too\n"
    "  walkcycle check exports/                  what is wrong with the files of a folder\n"
    "  walkcycle render --help                   all about one verb\n"
    "\nExit codes: 0 fine; 1 the file has errors, or pictures differ; 2 wrong usage, or a file that cannot "
    "be read or\n"
    "written; 3 no graphics device; 130 interrupted.";

void onInterrupt(int) {
    removeUnfinishedFiles();
    ::_exit(kInterrupted);
}

void installSignalHandlers() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, onInterrupt) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup wants it
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a FileError like any other
}

std::vector<Command> allCommands() {
    return {viewCommand(), renderCommand(),  infoCommand(),   checkCommand(),
            poseCommand(), compareCommand(), explainCommand()};
}

bool isVerb(const std::vector<Command>& commands, const std::string& word) {
    return std::any_of(commands.begin(), commands.end(),
                       [&](const Command& command) { return command.name == word; });
}

// `walkcycle hero.dae --clip run` is short for `walkcycle view hero.dae --clip run`.
void insertView(std::vector<std::string>& arguments, const std::vector<Command>& commands) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    if (isVerb(commands, first) || first == "--help" || first == "-h" || first == "--version") return;
    const bool looksLikeWord =
        !first.empty() && first.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
    std::error_code ignored;
    if (looksLikeWord && first[0] != '-' && !std::filesystem::exists(first, ignored))
        throw UsageError(
            "'" + first +
            "' is neither a file nor a verb (view, render, info, check, pose, compare, explain)");
    arguments.insert(arguments.begin(), "view");
}

int run(std::vector<std::string> arguments) {
    const std::vector<Command> commands = allCommands();
    insertView(arguments, commands);
    CLI::App app(kAbout, "walkcycle");
    app.footer(kExamples);
    app.set_version_flag("--version", versionText);
    app.require_subcommand(1);
    int exitCode = kFine;
    for (const Command& command : commands) {
        CLI::App* verb = app.add_subcommand(command.name, command.summary);
        Arguments options(*verb);
        command.declare(options);
        verb->final_callback([&exitCode, &command] { exitCode = command.run(); });
    }
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {  // --help and --version
        app.exit(success);
    } catch (const CLI::ParseError& error) {
        printError(std::string(error.what()) + " (walkcycle --help tells what there is)");
        return kWrongUsage;
    }
    return exitCode;
}

// A file that cannot even be opened counts as wrong usage; one that holds nothing to show, as faulty.
int exitCodeOf(const LoadError& error) {
    const bool unreadable =
        !error.diagnostics.empty() && error.diagnostics.back().code == info(Code::FileUnreadable).id;
    return unreadable ? kWrongUsage : kFaultsFound;
}

}  // namespace

int runProgram(std::vector<std::string> arguments) {
    installSignalHandlers();
    try {
        return run(std::move(arguments));
    } catch (const UsageError& error) {
        printError(error.what());
        return kWrongUsage;
    } catch (const FileError& error) {
        printError(error.what());
        return kWrongUsage;
    } catch (const LoadError& error) {  // said already
        return exitCodeOf(error);
    } catch (const StrictFailure&) {
        return kFaultsFound;
    } catch (const NoGraphicsDevice& error) {
        printError(error.what());
        return kNoGraphics;
    } catch (const std::bad_alloc&) {
        printError("there is not enough memory");
        return kFaultsFound;
    } catch (const std::exception& error) {
        printError(error.what());
        return kFaultsFound;
    }
}

}  // namespace walkcycle
