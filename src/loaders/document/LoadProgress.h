#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {

// Calls LoadOptions::progress with the share of a load that is done, and asks LoadOptions::cancelled whether to stop.
//
// Work is counted in bytes of the document's lists of numbers and names, which are nearly all of a large document. A list
// counts by the length of its text when it is read, and again if it is made into something that takes as long.
class LoadProgress {
public:
    enum class Stage { Document, Scene, Meshes, Curves, Keys };

    // `file` is the file in the message of a load that is cancelled before its document is parsed.
    LoadProgress(const LoadOptions& options, Diagnostics& diagnostics, std::string file)
        : options_(options), diagnostics_(diagnostics), file_(std::move(file)) {}

    // The share of Stage::Document that is done, 0 to 1. Like begin() and advance(), throws LoadError WC0802 if the caller
    // has cancelled.
    void documentIs(double share);
    // Measures the work of the later stages. (Skipped if LoadOptions::progress is not set.)
    void plan(XmlNode collada);
    // Adds the work of another document to the current stage.
    void alsoRead(XmlNode collada);

    void begin(Stage stage);
    // The same for a stage whose work is counted in other units than bytes, such as keys.
    void begin(Stage stage, double work);
    // Adds finished work of the current stage. Nearly free until there is something to report.
    void advance(double work) {
        waiting_ += work;
        if (waiting_ >= kPiece) reportStage();
    }
    void askWhetherToGoOn();
    void finish();

    // How much work is done between two looks at progress and cancellation: some milliseconds of reading numbers.
    static constexpr double kPiece = 1 << 18;
    // The work of a node and of a picture.
    static constexpr double kPerNode = 300.0, kPerPicture = 1 << 20;

private:
    void reportStage();
    void report(double share);

    const LoadOptions& options_;
    Diagnostics& diagnostics_;
    std::string file_;
    XmlNode collada_;               // empty until there is a document
    std::array<double, 5> work_{};  // per stage, in bytes; 0 for Stage::Document
    Stage stage_ = Stage::Document;
    double before_ = 0.0, share_ = 0.0;    // shares of the load: before the current stage, and of the stage
    double stageWork_ = 0.0, done_ = 0.0;  // of the current stage, in its own units
    double waiting_ = 0.0;                 // done, but not reported yet
    double reported_ = 0.0;                // the last reported share
};

}  // namespace walkcycle
