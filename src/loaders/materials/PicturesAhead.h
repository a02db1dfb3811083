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

// Decodes the pictures of a document on other threads while its meshes are read. It reports nothing: a
// picture that fails here is decoded again by the caller, who reports the fault. Without it, `check
// res/walker.dae` takes 12 % more wall time, and 41 % with four textures of 2048 x 2048 pixels.
class PicturesAhead {
public:
    PicturesAhead() = default;
    ~PicturesAhead();  // waits for the pictures that are being decoded; skips the others

    // Starts the threads. They decode the pictures that the <image>s of a document name, if the files are
    // where the document says and large enough together to be worth a thread.
    void begin(XmlNode collada, const DocumentSet& documents, const LoadOptions& options);

    // Returns a picture, waiting for it if it is being decoded. Null if it is not decoded here; then the
    // caller decodes it.
    std::shared_ptr<const Image> take(const std::string& path);

private:
    enum class State { Waiting, Working, Done, Left };  // Left: to the caller
    struct Item {
        std::string path;
        State state = State::Waiting;
        std::shared_ptr<const Image> image;
    };
    void collect(XmlNode collada, const DocumentSet& documents, const LoadOptions& options);
    void work(const LoadLimits& limits);
    Item* next();
    void leaveWaiting();  // call it with the mutex held

    std::vector<Item> items_;  // not resized while threads work
    std::vector<std::thread> threads_;
    std::uint64_t pixels_ = 0;  // decoded so far
    std::mutex mutex_;          // guards the items' states and pictures, and pixels_
    std::condition_variable done_;
};

}  // namespace walkcycle
