#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace walkcycle {

using Bytes = std::vector<std::uint8_t>;

// A file that cannot be read or written: the message is one sentence with the path and the system's reason.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Reads a whole regular file ("-": standard input). Refuses directories, FIFOs and devices, and files over maxBytes.
Bytes readFile(const std::string& path, std::uint64_t maxBytes);

// Writes a whole file or nothing: into a temporary file beside it, then renamed over it ("-": standard output).
// The temporary file is removed when writing fails or the program is interrupted.
void writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace walkcycle
