#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/Archive.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {

// The files around a document: the members of its archive, what the caller's resolver gives, or its folder on disk.
// Nothing outside the document's folder tree is opened unless LoadOptions::allowedPaths has it.
class Surroundings {
public:
    Surroundings(const LoadOptions& options, Diagnostics& diagnostics)
        : options_(options), diagnostics_(diagnostics) {}

    void useFolder(const std::filesystem::path& folder);
    void useArchive(Archive archive) { archive_.emplace(std::move(archive)); }

    // The bytes of a regular file; nothing where there is none or it may not be opened (reported at `from`).
    // Throws FileError or ArchiveError where it is there and cannot be read.
    // Of a file on disk no more than `most` bytes.
    std::optional<Bytes> read(const XmlNode& from, const std::filesystem::path& path,
                              std::size_t most = SIZE_MAX) const;
    // What the caller's resolver has at a path; it is asked once. Nothing where it has none. There must be a resolver.
    std::optional<Bytes> resolved(const std::string& path) const;
    // Whether that is a file on disk which read() would open.
    bool isPlainFile(const std::filesystem::path& path) const;
    // False where a folder is certainly not there, so that nothing need be looked for inside.
    bool mayHave(const std::filesystem::path& folder) const;
    // Names of the files in a folder, sorted. A folder is read once.
    const std::vector<std::string>& list(const std::filesystem::path& folder);

private:
    bool mayOpen(const std::filesystem::path& path) const;
    std::filesystem::path trueLocation(const std::filesystem::path& path, std::error_code& error) const;

    const LoadOptions& options_;
    Diagnostics& diagnostics_;
    std::optional<Archive> archive_;
    std::unordered_map<std::string, std::vector<std::string>> listed_;
    mutable std::unordered_map<std::string, ResolvedFile> resolved_;  // what the resolver said, by path
    mutable std::unordered_map<std::string, std::filesystem::path> folders_;  // where they truly are
    std::optional<std::filesystem::path>
        root_;  // canonical; none: a document in memory, with no files around it
};

}  // namespace walkcycle
