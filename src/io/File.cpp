#include "walkcycle/io/File.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace walkcycle {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

[[noreturn]] void fail(const char* what, const std::string& path, const std::string& reason) {
    throw FileError(std::string("cannot ") + what + " '" + path + "': " + reason);
}

[[noreturn]] void failWithErrno(const char* what, const std::string& path) {
    fail(what, path, std::generic_category().message(errno));
}

[[noreturn]] void failAsTooLarge(const std::string& path, std::uint64_t bytes, std::uint64_t maxBytes) {
    throw FileTooLarge(
        "cannot read '" + path + "': it is over the limit of " + std::to_string(maxBytes) + " bytes", bytes);
}

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }
    bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

private:
    int fd_;
};

// Refuses names with a zero byte: the system would read them up to the zero and open another file.
void requirePlainPath(const char* what, const std::string& path) {
    if (path.empty()) fail(what, path, "the name is empty");
    if (path.find('\0') != std::string::npos)
        fail(what, path.substr(0, path.find('\0')), "the name holds a zero byte");
}

const char* kindOfFile(mode_t mode) {
    if (S_ISDIR(mode)) return "it is a directory";
    if (S_ISFIFO(mode)) return "it is a pipe";
    if (S_ISSOCK(mode)) return "it is a socket";
    return "it is a device";
}

// Reads to the end of the file. The size from the system is only a hint, because files may grow.
Bytes readAll(int fd, std::uint64_t sizeHint, std::uint64_t maxBytes, const std::string& path) {
    Bytes bytes;
    std::size_t used = 0;
    bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(sizeHint, maxBytes)) + 1);
    while (true) {
        if (used == bytes.size()) bytes.resize(used + std::max(kChunk, used / 2));
        const ssize_t got = ::read(fd, bytes.data() + used, bytes.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) failWithErrno("read", path);
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
        if (used > maxBytes) failAsTooLarge(path, used, maxBytes);
    }
    bytes.resize(used);
    return bytes;
}

// Fails if the file changed while it was read: half an old and half a new file is neither.
void requireUnchanged(int fd, const struct stat& before, std::size_t got, const std::string& path) {
    struct stat after {};
    if (::fstat(fd, &after) != 0) failWithErrno("read", path);
    const bool asLong = before.st_size == 0 || got == static_cast<std::size_t>(before.st_size);
    if (asLong && after.st_size == before.st_size && after.st_mtim.tv_sec == before.st_mtim.tv_sec &&
        after.st_mtim.tv_nsec == before.st_mtim.tv_nsec)
        return;
    fail("read", path, "it changed while it was being read; try again when its writer is done");
}

void writeAll(int fd, std::span<const std::uint8_t> bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) failWithErrno("write", path);
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
}

// The names of the temporary files, for the signal handler. Whoever exchanges a slot for null owns the name
// in it.
std::array<std::atomic<char*>, 16> unfinishedFiles;

class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& path) : path_(path) {
        char* copy = ::strdup(path.c_str());
        for (std::atomic<char*>& slot : unfinishedFiles) {
            char* empty = nullptr;
            if (slot.compare_exchange_strong(empty, copy)) {
                slot_ = &slot;
                return;
            }
        }
        std::free(copy);  // sixteen writers at once: a signal leaves this file behind
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!finished_) ::unlink(path_.c_str());
        if (slot_) std::free(slot_->exchange(nullptr));
    }
    void finished() { finished_ = true; }

private:
    std::string path_;
    std::atomic<char*>* slot_ = nullptr;
    bool finished_ = false;
};

// The target of a symbolic link, or the path itself. Renaming must replace the target, not the link.
std::string linkTarget(const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return path;
    std::array<char, PATH_MAX> resolved{};
    return ::realpath(path.c_str(), resolved.data()) ? std::string(resolved.data()) : path;
}

std::string temporaryNameBeside(const std::string& path) {
    static std::atomic<unsigned> counter{0};
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
    std::string name;
    struct stat status {};
    do {  // process ids are reused, and a killed program may have left a file of this name
        name = folder + ".walkcycle-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
    } while (::lstat(name.c_str(), &status) == 0);
    return name;
}

void writeThrough(const std::string& path, std::span<const std::uint8_t> bytes) {
    // Without O_NONBLOCK, opening a pipe that nobody reads would wait for ever.
    Descriptor file(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.get() < 0) failWithErrno("write", path);
    ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) & ~O_NONBLOCK);
    writeAll(file.get(), bytes, path);
    if (!file.close()) failWithErrno("write", path);
}

void writeBesideAndRename(const std::string& path, std::span<const std::uint8_t> bytes, const mode_t* mode) {
    const std::string temporaryName = temporaryNameBeside(path);
    TemporaryFile temporary(temporaryName);
    Descriptor file(::open(temporaryName.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0) failWithErrno("write", path);
    writeAll(file.get(), bytes, path);
    if (mode && ::fchmod(file.get(), *mode & 07777) != 0) failWithErrno("write", path);
    if (!file.close()) failWithErrno("write", path);
    if (::rename(temporaryName.c_str(), path.c_str()) != 0) failWithErrno("write", path);
    temporary.finished();
}

}  // namespace

namespace {

// Opens a regular file for reading, and fills `status`.
Descriptor openRegular(const std::string& path, std::uint64_t maxBytes, struct stat& status) {
    requirePlainPath("read", path);
    if (::stat(path.c_str(), &status) != 0) failWithErrno("read", path);
    if (!S_ISREG(status.st_mode)) fail("read", path, kindOfFile(status.st_mode));
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0) failWithErrno("read", path);
    if (!S_ISREG(status.st_mode)) fail("read", path, kindOfFile(status.st_mode));
    const std::uint64_t size = static_cast<std::uint64_t>(status.st_size);
    if (size > maxBytes) failAsTooLarge(path, size, maxBytes);
    return file;
}

}  // namespace

Bytes readFile(const std::string& path, std::uint64_t maxBytes) {
    if (path == "-") return readAll(STDIN_FILENO, kChunk, maxBytes, "standard input");
    struct stat status {};
    const Descriptor file = openRegular(path, maxBytes, status);
    Bytes bytes = readAll(file.get(), static_cast<std::uint64_t>(status.st_size), maxBytes, path);
    requireUnchanged(file.get(), status, bytes.size(), path);
    return bytes;
}

Bytes readFileStart(const std::string& path, std::uint64_t maxBytes, std::size_t count) {
    struct stat status {};
    const Descriptor file = openRegular(path, maxBytes, status);
    Bytes bytes(count);
    ssize_t got = 0;
    do got = ::read(file.get(), bytes.data(), bytes.size());
    while (got < 0 && errno == EINTR);
    if (got < 0) failWithErrno("read", path);
    bytes.resize(static_cast<std::size_t>(got));
    return bytes;
}

void writeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
    if (path == "-") return writeAll(STDOUT_FILENO, bytes, "standard output");
    requirePlainPath("write", path);
    const std::string target = linkTarget(path);
    struct stat status {};
    if (::stat(target.c_str(), &status) != 0) return writeBesideAndRename(target, bytes, nullptr);
    if (S_ISDIR(status.st_mode)) fail("write", path, kindOfFile(status.st_mode));
    if (!S_ISREG(status.st_mode)) return writeThrough(target, bytes);
    // Renaming needs permission for the folder only, so permission for the file is checked here: a read-only
    // file is kept.
    if (::access(target.c_str(), W_OK) != 0) failWithErrno("write", path);
    writeBesideAndRename(target, bytes, &status.st_mode);
}

void removeUnfinishedFiles() noexcept {
    for (std::atomic<char*>& slot : unfinishedFiles)
        if (char* path = slot.exchange(nullptr)) ::unlink(path);  // not freed: this is a signal handler
}

}  // namespace walkcycle
