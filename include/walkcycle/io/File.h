#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include <walkcycle/Export.h>
#include <walkcycle/io/Bytes.h>

namespace walkcycle {

// A file that cannot be read or written: what() is one sentence with the path and the system's reason.
struct WALKCYCLE_API FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The file is there, and larger than maxBytes.
struct WALKCYCLE_API FileTooLarge : FileError {
    FileTooLarge(const std::string& what, std::uint64_t bytes) : FileError(what), amount(bytes) {}
    std::uint64_t amount;  // bytes; the file has at least as many
};

// Reads a whole regular file ("-": standard input). Throws FileTooLarge for files over maxBytes, and FileError for what is
// not there, directories, pipes and devices, and files that change while they are read.
WALKCYCLE_API Bytes readFile(const std::string& path, std::uint64_t maxBytes = UINT64_MAX);

// Reads at most the first `count` bytes. Refuses the same files.
WALKCYCLE_API Bytes readFileStart(const std::string& path, std::uint64_t maxBytes, std::size_t count);

// Writes a whole file or nothing: a temporary file beside it is written, then renamed to it ("-": standard
// output). Throws FileError, after the temporary file is removed. A link is followed, not replaced; pipes and
// devices are written to as they are.
WALKCYCLE_API void writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

// Removes the temporary files of every unfinished writeFile(). For a signal handler that ends the program: it is
// async-signal-safe.
WALKCYCLE_API void removeUnfinishedFiles() noexcept;

}  // namespace walkcycle
