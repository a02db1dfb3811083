#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "io/Bytes.h"

namespace walkcycle {

// A file that cannot be read or written: the message is one sentence with the path and the system's reason.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The file exists, but is larger than the caller allows.
struct FileTooLarge : FileError {
    FileTooLarge(const std::string& what, std::uint64_t bytes) : FileError(what), amount(bytes) {}
    std::uint64_t amount;  // in bytes, at least
};

// Reads a whole regular file ("-": standard input). Refuses directories, FIFOs and devices, files over maxBytes
// (FileTooLarge), and files that change meanwhile.
Bytes readFile(const std::string& path, std::uint64_t maxBytes);

// Reads at most the first `count` bytes. Refuses the same files.
Bytes readFileStart(const std::string& path, std::uint64_t maxBytes, std::size_t count);

// Writes a whole file or nothing: a temporary file beside it is written, then renamed to it ("-": standard
// output). The temporary file is removed when writing fails or the program is interrupted. A link is
// followed, not replaced; pipes and devices are written to as they are.
void writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

// Removes the temporary files of every unfinished writeFile(). For signal handlers: it is async-signal-safe.
void removeUnfinishedFiles() noexcept;

}  // namespace walkcycle
