#include "app/Program.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <new>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "io/File.h"
#include "io/Image.h"
#include "loaders/Diagnostics.h"
#include "platform/DisplayLoss.h"
#include "platform/NoGraphicsDevice.h"
#include "render/GraphicsError.h"

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
    "written; 3 no graphics device, or it is lost; 130 interrupted, 143 terminated.";

// As a shell says it: 130 after SIGINT, 143 after SIGTERM.
void onInterrupt(int signal) {
    removeUnfinishedFiles();
    ::_exit(kInterrupted - SIGINT + signal);
}

void onDisplayLost() {
    removeUnfinishedFiles();
    printError("the display is gone");
    ::_exit(kNoGraphics);
}

void installHandlers() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, onInterrupt) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup wants it
    // A closed pipe and a file that may not grow further are FileErrors like any other.
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
    whenDisplayIsLost(onDisplayLost);
}

// Where a standard stream is closed, the next file that is opened would take its number, and what is printed would
// end up there. A stream that can do nothing keeps the place.
void holdStandardStreams() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(fd, F_GETFD) >= 0) continue;
        const int opened = ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (opened != fd && opened >= 0) ::close(opened);
    }
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
    const bool forHelp = !isVerb(commands, arguments.front());  // which is about all of them
    for (const Command& command : commands) {
        if (!forHelp && command.name != arguments.front()) continue;
        CLI::App* verb = app.add_subcommand(command.name, command.summary);
        Arguments options(*verb);
        command.declare(options);
        verb->final_callback([&exitCode, &command] { exitCode = command.run(); });
    }
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {  // --help and --version
        std::ostringstream help;
        app.exit(success, help, help);
        printOut(help.str());
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
    holdStandardStreams();
    installHandlers();
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
    } catch (const GraphicsError& error) {
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
