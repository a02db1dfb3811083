#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
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

// The files around a document: those of its archive, those that the caller's resolver returns, or those on disk. On disk,
// only files in the document's folder, in folders below it and in LoadOptions::allowedPaths are opened.
class Surroundings {
public:
    Surroundings(const LoadOptions& options, Diagnostics& diagnostics)
        : options_(options), diagnostics_(diagnostics) {}

    void useFolder(const std::filesystem::path& folder);
    void useArchive(Archive archive) { archive_.emplace(std::move(archive)); }

    // The bytes of a regular file, of a file on disk at most the first `most`. Returns nothing if there is no such file, or if
    // it may not be opened (reported at `from`). Throws FileError or ArchiveError if the file exists and cannot be read.
    std::optional<Bytes> read(const XmlNode& from, const std::filesystem::path& path,
                              std::size_t most = SIZE_MAX) const;
    // The file that the caller's resolver has at a path; nothing if it has none. Asks it once per path.
    // There must be a resolver. Throws its FileErrors.
    std::optional<Bytes> resolved(const std::string& path) const;
    // Whether there is such a file on disk and read() would open it.
    bool isPlainFile(const std::filesystem::path& path) const;
    // Returns false if there is certainly no such folder, so that a search can skip it.
    bool mayHave(const std::filesystem::path& folder) const;
    // Names of the files in a folder, sorted. A folder is read once.
    const std::vector<std::string>& list(const std::filesystem::path& folder);

private:
    // What the caller's resolver returned for a path, or the FileError that it threw.
    struct Answer {
        ResolvedFile file{std::nullopt};
        std::exception_ptr failure;
    };

    bool mayOpen(const std::filesystem::path& path) const;
    std::filesystem::path trueLocation(const std::filesystem::path& path, std::error_code& error) const;

    const LoadOptions& options_;
    Diagnostics& diagnostics_;
    std::optional<Archive> archive_;
    std::unordered_map<std::string, std::vector<std::string>> listed_;
    mutable std::unordered_map<std::string, Answer> resolved_;                // by path
    mutable std::unordered_map<std::string, std::filesystem::path> folders_;  // resolved, by path
    // The document's folder, resolved; none for a document in memory, which has no files on disk around it.
    std::optional<std::filesystem::path> root_;
};

}  // namespace walkcycle
