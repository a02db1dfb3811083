#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <unistd.h>

#include "app/RunProgram.h"
#include "io/TestFolder.h"

// What the tests of faults outside the file share.
namespace walkcycle {

inline std::string textOf(const std::string& path) {
    const Bytes bytes = readFile(path, std::uint64_t{1} << 30);
    return {bytes.begin(), bytes.end()};
}

inline long linesOf(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

// Starts the program with a standard stream redirected, as in shell(">&-").
inline std::vector<std::string> shell(const std::string& redirection) {
    return {"/bin/sh", "-c", "exec \"$0\" \"$@\" " + redirection};
}

// Permissions mean nothing to root, who may read and write everything: without that right, root is like all others.
inline std::vector<std::string> withoutPrivileges() {
    if (::geteuid() != 0) return {};
    return {"/usr/bin/setpriv", "--bounding-set=-dac_override,-dac_read_search"};
}

// The leak checker cannot work under another tracer.
inline std::map<std::string, std::string> traced() {
    return {{"ASAN_OPTIONS", "detect_leaks=0"}};
}

// strace that logs system calls and has some of them fail: the faults that no file system gives on demand.
inline std::vector<std::string> strace(const std::string& log, std::vector<std::string> options) {
    options.insert(options.begin(), {"/usr/bin/strace", "-f", "-s", "4096", "-o", log});
    return options;
}

inline bool canTrace() {
    const TestFolder folder;
    return runWalkcycle({"--version"}, "", traced(), strace(folder / "log", {})).exitCode == 0;
}

}  // namespace walkcycle
