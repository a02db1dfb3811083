#include "app/RunProgram.h"

#include <cstdint>
#include <cstdlib>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/TestFolder.h"

namespace walkcycle {
namespace {

std::string textOf(const std::string& path) {
    const Bytes bytes = readFile(path, std::uint64_t{1} << 30);
    return {bytes.begin(), bytes.end()};
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& text : strings) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

std::vector<std::string> environmentWith(const std::map<std::string, std::string>& changes) {
    std::vector<std::string> result;
    for (char** entry = environ; *entry; ++entry) {
        const std::string text = *entry;
        if (!changes.contains(text.substr(0, text.find('=')))) result.push_back(text);
    }
    for (const auto& [name, value] : changes)
        if (!value.empty()) result.push_back(name + "=" + value);
    return result;
}

}  // namespace

Ran runWalkcycle(const std::vector<std::string>& arguments, const std::string& input,
                 const std::map<std::string, std::string>& environment,
                 const std::vector<std::string>& wrapper) {
    const TestFolder folder;
    const std::string in = folder / "in", out = folder / "out", err = folder / "err";
    writeFile(in, bytesOf(input));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
    std::vector<std::string> words = wrapper, variables = environmentWith(environment);
    words.push_back(WALKCYCLE_PROGRAM);
    words.insert(words.end(), arguments.begin(), arguments.end());
    pid_t process = 0;
    const int failed = posix_spawn(&process, words.front().c_str(), &actions, nullptr, pointers(words).data(),
                                   pointers(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    Ran ran;
    int status = 0;
    if (failed != 0 || waitpid(process, &status, 0) != process) return ran;
    ran.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.out = textOf(out);
    ran.err = textOf(err);
    return ran;
}

}  // namespace walkcycle
