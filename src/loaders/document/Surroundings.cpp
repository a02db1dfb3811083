#include "loaders/document/Surroundings.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>

#include <dirent.h>
#include <sys/stat.h>

namespace walkcycle {
namespace fs = std::filesystem;
namespace {

// If the folder cannot be resolved (it is empty then), every path counts as outside it.
bool isInside(const fs::path& path, const fs::path& folder) {
    if (folder.empty()) return false;
    const auto end = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first;
    return end == folder.end() || (std::next(end) == folder.end() && end->empty());
}

std::vector<std::string> namesIn(const Archive& archive, const fs::path& folder) {
    const fs::path normal = folder.lexically_normal();
    std::vector<std::string> names;
    for (const std::string& name : archive.names()) {
        const fs::path entry(name);
        if (entry.has_filename() && entry.parent_path() == (normal == "." ? fs::path() : normal))
            names.push_back(entry.filename().string());
    }
    return names;
}

// Not by std::filesystem::directory_iterator: that of GCC 12 ends the program if memory runs out.
std::vector<std::string> namesIn(const fs::path& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> directory(::opendir(folder.c_str()), ::closedir);
    if (!directory && errno == ENOMEM) throw std::bad_alloc();
    std::vector<std::string> names;
    while (const dirent* entry = directory ? ::readdir(directory.get()) : nullptr) {
        struct stat status {};
        if (::fstatat(::dirfd(directory.get()), entry->d_name, &status, 0) == 0 && S_ISREG(status.st_mode))
            names.emplace_back(entry->d_name);
    }
    return names;
}

}  // namespace

// The path is made absolute first, because weakly_canonical leaves a relative path relative if nothing of it
// exists. Resolving asks the system about each component, so the result for a folder is kept. The last
// component is not resolved unless it is a symbolic link.
fs::path Surroundings::trueLocation(const fs::path& path, std::error_code& error) const {
    const fs::path absolute = fs::absolute(path, error);
    if (error) return {};
    const fs::path name = absolute.filename();
    std::error_code unseen;
    const fs::file_type type = fs::symlink_status(absolute, unseen).type();
    const bool isPlain = type == fs::file_type::regular || type == fs::file_type::not_found;
    if (!isPlain || name.empty() || name == "." || name == "..") return fs::weakly_canonical(absolute, error);
    const auto [folder, isNew] = folders_.try_emplace(absolute.parent_path().string());
    if (isNew) folder->second = fs::weakly_canonical(absolute.parent_path(), error);
    if (!error) return folder->second / name;
    folders_.erase(folder);
    return {};
}

void Surroundings::useFolder(const fs::path& folder) {
    std::error_code error;
    root_ = trueLocation(folder.empty() ? fs::path(".") : folder, error);
}

bool Surroundings::mayOpen(const fs::path& path) const {
    std::error_code error;
    const fs::path meant = trueLocation(path, error);
    if (error || !root_) return false;
    if (isInside(meant, *root_)) return true;
    return std::any_of(
        options_.allowedPaths.begin(), options_.allowedPaths.end(),
        [&](const std::string& allowed) { return isInside(meant, trueLocation(fs::path(allowed), error)); });
}

// Caches the answers: two textures may name one picture by different URIs, and a search tries some paths twice.
std::optional<Bytes> Surroundings::resolved(const std::string& path) const {
    const auto [answer, isNew] = resolved_.try_emplace(path);
    if (isNew) {
        try {
            answer->second.file = options_.resolver(path);
        } catch (const FileError&) {
            answer->second.failure = std::current_exception();
        }
    }
    if (answer->second.failure) std::rethrow_exception(answer->second.failure);
    const ResolvedFile& file = answer->second.file;
    return file.found() ? std::optional(file.bytes()) : std::nullopt;
}

std::optional<Bytes> Surroundings::read(const XmlNode& from, const fs::path& path, std::size_t most) const {
    const std::string normal = path.lexically_normal().string();
    if (archive_) return archive_->contains(normal) ? std::optional(archive_->read(normal)) : std::nullopt;
    if (options_.resolver) return resolved(normal);
    if (!root_) return std::nullopt;
    if (!mayOpen(path)) {
        diagnostics_.report(Code::ExternalRefused, from, {path.string()});
        return std::nullopt;
    }
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return std::nullopt;
    const std::uint64_t maxBytes = options_.limits.maxFileBytes;
    return most == SIZE_MAX ? readFile(path.string(), maxBytes)
                            : readFileStart(path.string(), maxBytes, most);
}

bool Surroundings::isPlainFile(const fs::path& path) const {
    std::error_code error;
    return !archive_ && !options_.resolver && root_ && mayOpen(path) && fs::is_regular_file(path, error);
}

bool Surroundings::mayHave(const fs::path& folder) const {
    std::error_code error;
    return archive_ || options_.resolver || (root_ && fs::is_directory(folder, error));
}

const std::vector<std::string>& Surroundings::list(const fs::path& folder) {
    const auto [entry, isNew] = listed_.try_emplace(folder.lexically_normal().string());
    std::vector<std::string>& names = entry->second;
    if (!isNew) return names;
    if (archive_) {
        names = namesIn(*archive_, folder);
    } else if (!options_.resolver && mayOpen(folder)) {
        names = namesIn(folder);
    }
    std::sort(names.begin(), names.end());  // file systems list a folder in different orders
    return names;
}

}  // namespace walkcycle
