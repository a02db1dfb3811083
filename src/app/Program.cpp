#include "app/Program.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <new>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/Joined.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/text/Spelling.h"
#include "platform/DisplayLoss.h"
#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"
#include "walkcycle/platform/NoGraphicsDevice.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {
namespace {

constexpr const char* kAbout =
    "Walkcycle opens COLLADA characters (.dae, .zae), plays and draws them, and says what is wrong with "
    "their "
    "files.";
constexpr const char* kExamples =
    "`walkcycle FILE` means `walkcycle view FILE`; without a FILE, the built-in character walks.\n"
    "\nExamples:\n"
    "  walkcycle                                 the built-in character, in a window\n"
    "  walkcycle hero.dae                        a character of yours\n"
    "  walkcycle render hero.dae -o hero.png     a picture, even without a display\n"
    "  walkcycle check exports/                  what is wrong with the files of a folder\n"
    "  walkcycle render --help                   the options of one verb\n"
    "\nExit codes: 0 fine; 1 the file has errors, or pictures differ; 2 wrong usage, or a file that cannot "
    "be read or\n"
    "written; 3 no graphics device, or it is lost; 130 interrupted, 143 terminated.";

// Exits as shells expect: with 130 after SIGINT, 143 after SIGTERM.
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
        if (std::signal(signal, onInterrupt) == SIG_IGN)
            std::signal(signal, SIG_IGN);  // set by nohup, for example
    // Ignored, so that a write to a closed pipe, or beyond the largest allowed file, throws FileError like any failed
    // write.
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
    whenDisplayIsLost(onDisplayLost);
}

// If a standard stream is closed, the next file that is opened would get its number, and messages would be printed into
// that file. So /dev/null takes the number.
void holdStandardStreams() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(fd, F_GETFD) >= 0) continue;
        const int opened = ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (opened != fd && opened >= 0) ::close(opened);
    }
}

bool isVerb(const std::vector<Command>& commands, const std::string& word) {
    return std::any_of(commands.begin(), commands.end(),
                       [&](const Command& command) { return command.name == word; });
}

[[noreturn]] void failAsNeitherFileNorVerb(const std::vector<Command>& commands, const std::string& word) {
    std::vector<std::string> verbs;
    for (const Command& command : commands) verbs.push_back(command.name);
    throw UsageError("'" + word + "' is neither a file nor a verb (" + joined(verbs, ", ") + ")" +
                     didYouMean(word, joined(verbs, " ")));
}

// The end of a message about an option that a verb does not have: the nearest option, if one is near.
std::string nearestOption(const std::string& unknown, const CLI::App& verb, const std::string& ofTheProgram) {
    if (!unknown.starts_with("--")) return "";
    std::string options = ofTheProgram;
    for (const CLI::Option* option : verb.get_options())
        for (const std::string& name : option->get_lnames()) options += " --" + name;
    return didYouMean(unknown, options);
}

std::string unexpectedArgument(const CLI::App& verb, const std::string& ofTheProgram) {
    const std::vector<std::string> unexpected = verb.remaining();
    for (const std::string& argument : unexpected) {
        const std::string option = argument.substr(0, argument.find('='));
        if (option.size() > 1 && option[0] == '-')
            return verb.get_name() + " has no option '" + option + "'" +
                   nearestOption(option, verb, ofTheProgram);
    }
    return verb.get_name() + " does not take '" + joined(unexpected, "', '") + "' as well";
}

// What is wrong with the arguments of a verb, in plainer words than CLI11's. `ofTheProgram` are the options that are also
// possible.
std::string wrongUsage(const CLI::ParseError& error, const CLI::App& verb, const std::string& ofTheProgram) {
    const std::string text = error.what(), option = text.substr(0, text.find(':'));
    if (dynamic_cast<const CLI::ExtrasError*>(&error)) return unexpectedArgument(verb, ofTheProgram);
    if (!dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return text;
    if (text.ends_with("missing")) return option + " needs a value";
    return text.find("received") == std::string::npos ? text : option + " can be given once only";
}

// `walkcycle hero.dae --clip run` is short for `walkcycle view hero.dae --clip run`. Returns whether it was that.
bool insertView(std::vector<std::string>& arguments, const std::vector<Command>& commands) {
    const std::string first = arguments.empty() ? "" : arguments.front();
    if (isVerb(commands, first) || first == "--help" || first == "-h" || first == "--version") return false;
    const bool looksLikeWord =
        !first.empty() && first.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
    std::error_code ignored;
    if (looksLikeWord && first[0] != '-' && !std::filesystem::exists(first, ignored))
        failAsNeitherFileNorVerb(commands, first);
    arguments.insert(arguments.begin(), "view");
    return true;
}

int run(std::vector<std::string> arguments) {
    const std::vector<Command> commands = allCommands();
    const std::string ofTheProgram = insertView(arguments, commands) ? "--version" : "";
    CLI::App app(kAbout, "walkcycle");
    CLI::App* verb = nullptr;
    app.footer(kExamples);
    app.set_version_flag("--version", versionText);
    app.require_subcommand(1);
    int exitCode = kFine;
    const bool forHelp = !isVerb(commands, arguments.front());  // --help or --version of the whole program
    for (const Command& command : commands) {
        if (!forHelp && command.name != arguments.front()) continue;
        verb = app.add_subcommand(command.name, command.summary);
        Arguments options(*verb);
        command.declare(options);
        verb->final_callback([&exitCode, &command] { exitCode = command.run(); });
    }
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes the last argument first
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {  // --help and --version
        std::ostringstream help;
        app.exit(success, help, help);
        printOut(help.str());
    } catch (const CLI::ParseError& error) {
        printError((forHelp ? error.what() : wrongUsage(error, *verb, ofTheProgram)) + " (walkcycle " +
                   (forHelp ? "" : verb->get_name() + " ") + "--help shows the usage)");
        return kWrongUsage;
    }
    return exitCode;
}

// A file that cannot be read counts as wrong usage, a file of which nothing can be shown as faulty.
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
    } catch (const LoadError& error) {  // printed already
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
