#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include <walkcycle/Export.h>
#include <walkcycle/io/Bytes.h>

namespace walkcycle {

// A file cannot be read or written. what() is one sentence with the path and the reason that the system
// gives.
struct WALKCYCLE_API FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The file is larger than maxBytes.
struct WALKCYCLE_API FileTooLarge : FileError {
    FileTooLarge(const std::string& what, std::uint64_t bytes) : FileError(what), amount(bytes) {}
    std::uint64_t amount;  // in bytes: the size of the file, or how much was read of standard input
};

// Reads a whole regular file; "-" is standard input. Throws FileTooLarge if the file is larger than maxBytes.
// Throws FileError if it does not exist, is a directory, pipe or device, or changes while it is read.
WALKCYCLE_API Bytes readFile(const std::string& path, std::uint64_t maxBytes = UINT64_MAX);

// Reads the first `count` bytes, or all if the file has fewer. Throws like readFile(), also if the whole file
// is larger than maxBytes. "-" is a file name here.
WALKCYCLE_API Bytes readFileStart(const std::string& path, std::uint64_t maxBytes, std::size_t count);

// Writes a whole file or nothing: writes a temporary file beside it, then renames it. "-" is standard output.
// Throws FileError, after it has removed the temporary file. The target of a symbolic link is replaced, not
// the link; pipes and devices are written to directly. The permissions of an existing file are kept, and a
// read-only one is refused.
WALKCYCLE_API void writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

// Removes the temporary files of all unfinished writeFile() calls. For a signal handler that ends the
// program: it is async-signal-safe.
WALKCYCLE_API void removeUnfinishedFiles() noexcept;

}  // namespace walkcycle
