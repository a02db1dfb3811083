#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {

// Tells the caller of a load how much of it is done, and asks whether to go on (LoadOptions::progress and cancelled).
//
// Work is counted in bytes of the document's lists of numbers and names, which are nearly all of a large document: a list
// counts with the length of its text when it is read, and once more when something is made of it that takes as long.
class LoadProgress {
public:
    enum class Stage { Document, Scene, Meshes, Curves, Keys };

    // `file` is what the load was asked for: it names the place of a load that is cancelled before it has a document.
    LoadProgress(const LoadOptions& options, Diagnostics& diagnostics, std::string file)
        : options_(options), diagnostics_(diagnostics), file_(std::move(file)) {}

    // So much of Stage::Document is done, of 1. Each of these functions throws LoadError WC0802 where the caller cancels.
    void documentIs(double share);
    // Measures what the later stages have to do. (Where nobody wants to know, nothing is measured.)
    void plan(XmlNode collada);
    // Another document belongs to the stage that is under way.
    void alsoRead(XmlNode collada);

    void begin(Stage stage);
    // The same where the work of the stage is known in other units than bytes, such as keys.
    void begin(Stage stage, double work);
    // So much more of the stage's work is done. Nearly free until there is something to tell.
    void advance(double work) {
        waiting_ += work;
        if (waiting_ >= kPiece) tell();
    }
    void askWhetherToGoOn();
    void finish();

    // How much work a piece may be that nobody is told of: some milliseconds of reading numbers.
    static constexpr double kPiece = 1 << 18;
    // What a node and a picture count as.
    static constexpr double kPerNode = 300.0, kPerPicture = 1 << 20;

private:
    void tell();
    void report(double share);

    const LoadOptions& options_;
    Diagnostics& diagnostics_;
    std::string file_;
    XmlNode collada_;               // nothing until there is a document
    std::array<double, 5> work_{};  // per stage, in bytes; of Stage::Document nothing
    Stage stage_ = Stage::Document;
    double before_ = 0.0, share_ = 0.0;    // of the whole: where the stage begins, and how much it is
    double stageWork_ = 0.0, done_ = 0.0;  // of the stage, in its own units
    double waiting_ = 0.0;                 // done, and not told yet
    double told_ = 0.0;                    // the last share that the caller was told
};

}  // namespace walkcycle
