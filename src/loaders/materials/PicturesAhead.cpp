#include "loaders/materials/PicturesAhead.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/ImageDecoder.h"
#include "io/Uri.h"
#include "walkcycle/io/File.h"

namespace walkcycle {
namespace {

// Bytes of all files together. Fewer are decoded in about the time that it takes to start a thread and hand
// over the picture.
constexpr std::uint64_t kWorthAThread = std::uint64_t{1} << 18;

std::string uriOf(XmlNode image) {
    const XmlNode init = image.child("init_from"), ref = init.child("ref");  // <ref>: COLLADA 1.5
    return ref ? ref.text() : init.text();
}

// Each thread may hold one picture beyond LoadLimits::maxTotalPixels, because pixels are counted after
// decoding.
constexpr std::size_t kMostThreads = 3;

}  // namespace

PicturesAhead::~PicturesAhead() {
    {
        const std::lock_guard lock(mutex_);
        leaveWaiting();
    }
    for (std::thread& thread : threads_) thread.join();
}

void PicturesAhead::begin(XmlNode collada, const DocumentSet& documents, const LoadOptions& options) {
    const unsigned processors = std::thread::hardware_concurrency();
    if (!options.loadImages || !options.imagePixels || !options.texture.empty() || processors < 2) return;
    collect(collada, documents, options);
    const std::size_t threads = std::min<std::size_t>({items_.size(), processors - 1, kMostThreads});
    threads_.reserve(threads);
    try {
        while (threads_.size() < threads)
            threads_.emplace_back([this, limits = options.limits] { work(limits); });
    } catch (
        const std::system_error&) {  // the system has no more threads: the others, or the caller, decode all
    }
}

void PicturesAhead::collect(XmlNode collada, const DocumentSet& documents, const LoadOptions& options) {
    std::uint64_t bytes = 0;
    for (XmlNode library : collada.children("library_images"))
        for (XmlNode image : library.children("image")) {
            const Uri uri = parseUri(uriOf(image));
            if (!uri.scheme.empty() || uri.path.empty()) continue;
            const std::string path = documents.plainFileBeside(image, uri.path);
            const auto same = [&](const Item& item) { return item.path == path; };
            if (path.empty() || std::any_of(items_.begin(), items_.end(), same)) continue;
            std::error_code error;
            const std::uint64_t size = std::filesystem::file_size(path, error);
            if (error || size > options.limits.maxFileBytes) continue;
            bytes += size;
            items_.push_back({path, State::Waiting, nullptr});
        }
    if (bytes < kWorthAThread) items_.clear();
}

PicturesAhead::Item* PicturesAhead::next() {
    const std::lock_guard lock(mutex_);
    const auto waiting = std::find_if(items_.begin(), items_.end(),
                                      [](const Item& item) { return item.state == State::Waiting; });
    if (waiting == items_.end()) return nullptr;
    waiting->state = State::Working;
    return &*waiting;
}

void PicturesAhead::work(const LoadLimits& limits) {
    while (Item* const item = next()) {
        std::shared_ptr<const Image> image;
        try {
            image = std::make_shared<const Image>(
                decodeImage(readFile(item->path, limits.maxFileBytes), limits.image()));
        } catch (const std::exception&) {  // the caller decodes it again and reports the fault
        }
        const std::lock_guard lock(mutex_);
        if (image) pixels_ += static_cast<std::uint64_t>(std::int64_t{image->width} * image->height);
        // If all pictures together exceed the limit, decoding stops here; PictureFinder reports it.
        if (pixels_ > limits.maxTotalPixels) image = nullptr, leaveWaiting();
        item->state = image ? State::Done : State::Left;
        item->image = std::move(image);
        done_.notify_all();
    }
}

void PicturesAhead::leaveWaiting() {
    for (Item& item : items_)
        if (item.state == State::Waiting) item.state = State::Left;
}

std::shared_ptr<const Image> PicturesAhead::take(const std::string& path) {
    const auto found =
        std::find_if(items_.begin(), items_.end(), [&](const Item& item) { return item.path == path; });
    if (found == items_.end()) return nullptr;
    std::unique_lock lock(mutex_);
    if (found->state == State::Waiting) found->state = State::Left;
    done_.wait(lock, [&] { return found->state != State::Working; });
    return std::move(found->image);
}

}  // namespace walkcycle
