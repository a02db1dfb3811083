#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "loaders/document/DocumentSet.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/io/Image.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {

// Decodes a document's pictures on other threads while its meshes are read. It says nothing of what goes wrong: whoever
// needs a picture that could not be decoded here does so himself, and reports what there is to report.
// Without it, `check res/walker.dae` takes 12 % more wall time, and 41 % with four textures of 2048 x 2048 pixels.
class PicturesAhead {
public:
    PicturesAhead() = default;
    ~PicturesAhead();  // waits for the pictures that are being decoded; leaves the others

    // Begins with the pictures that the <image>s of a document name, where they lie as written, beside the document on
    // disk, and are so large that it is worth a thread.
    void begin(XmlNode collada, const DocumentSet& documents, const LoadOptions& options);

    // A picture that was decoded ahead, or is being decoded; null where none was, which is then the caller's.
    std::shared_ptr<const Image> take(const std::string& path);

private:
    enum class State { Waiting, Working, Done, Left };
    struct Item {
        std::string path;
        State state = State::Waiting;
        std::shared_ptr<const Image> image;
    };
    void collect(XmlNode collada, const DocumentSet& documents, const LoadOptions& options);
    void work(const LoadLimits& limits);
    Item* next();
    void leaveWaiting();  // with the mutex held

    std::vector<Item> items_;  // not resized while threads work
    std::vector<std::thread> threads_;
    std::uint64_t pixels_ = 0;  // decoded
    std::mutex mutex_;          // guards the items' states and pictures, and pixels_
    std::condition_variable done_;
};

}  // namespace walkcycle
