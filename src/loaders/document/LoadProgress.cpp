#include "loaders/document/LoadProgress.h"

#include <algorithm>
#include <numeric>

#include "loaders/text/NumberText.h"

namespace walkcycle {
namespace {

// The share of reading and parsing in a load, for a document that is mostly numbers.
constexpr double kDocumentShare = 0.2;
// Smaller steps are not reported.
constexpr double kLeastStep = 1.0 / 128.0;
// The work of each stage besides numbers.
constexpr double kPerStage = 1000.0;

std::size_t at(LoadProgress::Stage stage) {
    return static_cast<std::size_t>(stage);
}

// The element after `node` in document order, inside `root`; nothing at the end.
XmlNode nextInside(XmlNode root, XmlNode node) {
    if (const XmlNode child = node.firstChild()) return child;
    while (!(node == root)) {
        if (const XmlNode sibling = node.nextSibling()) return sibling;
        node = node.parent();
    }
    return {};
}

// The bytes of the number lists of a library. <p> counts twice: its corners are read, and then made into vertices.
double bytesOf(XmlNode library) {
    double bytes = 0.0;
    std::string joined;
    for (XmlNode node = nextInside(library, library); node; node = nextInside(library, node)) {
        if (!holdsNumberText(node.name())) continue;
        const auto size = static_cast<double>(node.rawText(joined).size());
        bytes += node.is("p") ? 2.0 * size : size;
    }
    return bytes;
}

double nodesOf(XmlNode library) {
    double nodes = 0.0;
    for (XmlNode node = nextInside(library, library); node; node = nextInside(library, node))
        nodes += node.is("node") ? 1.0 : 0.0;
    return nodes;
}

double imagesOf(XmlNode library) {
    double images = 0.0;
    for ([[maybe_unused]] XmlNode image : library.children("image")) ++images;
    return images;
}

void addWork(XmlNode collada, bool decodesPictures, std::array<double, 5>& work) {
    using Stage = LoadProgress::Stage;
    for (XmlNode library : collada.children()) {
        if (library.is("library_geometries") || library.is("library_controllers"))
            work[at(Stage::Meshes)] += bytesOf(library);
        if (library.is("library_images") && decodesPictures)
            work[at(Stage::Meshes)] += LoadProgress::kPerPicture * imagesOf(library);
        if (library.is("library_visual_scenes") || library.is("library_nodes"))
            work[at(Stage::Scene)] += LoadProgress::kPerNode * nodesOf(library);
        if (!library.is("library_animations")) continue;
        const double bytes = bytesOf(library);
        work[at(Stage::Curves)] += bytes;
        work[at(Stage::Keys)] += bytes;
    }
}

}  // namespace

void LoadProgress::documentIs(double share) {
    report(kDocumentShare * share);
    askWhetherToGoOn();
}

void LoadProgress::plan(XmlNode collada) {
    collada_ = collada;
    work_.fill(kPerStage);
    work_[at(Stage::Document)] = 0.0;
    if (options_.progress) addWork(collada, options_.loadImages && options_.imagePixels, work_);
}

void LoadProgress::alsoRead(XmlNode collada) {
    if (!options_.progress) return;
    std::array<double, 5> more{};
    addWork(collada, false, more);
    stageWork_ += more[at(stage_)];
}

void LoadProgress::begin(Stage stage) {
    begin(stage, work_[at(stage)]);
}

void LoadProgress::begin(Stage stage, double work) {
    const auto first = work_.begin(), here = first + static_cast<std::ptrdiff_t>(at(stage));
    const double all = std::accumulate(first, work_.end(), 0.0);
    before_ = kDocumentShare + (1.0 - kDocumentShare) * std::accumulate(first, here, 0.0) / all;
    share_ = (1.0 - kDocumentShare) * *here / all;
    stage_ = stage;
    stageWork_ = work;
    done_ = waiting_ = 0.0;
    reportStage();
}

void LoadProgress::reportStage() {
    done_ += waiting_;
    waiting_ = 0.0;
    report(before_ + share_ * std::min(1.0, done_ / std::max(stageWork_, 1.0)));
    askWhetherToGoOn();
}

void LoadProgress::report(double share) {
    if (!options_.progress || share < reported_ + kLeastStep || share >= 1.0) return;
    reported_ = share;
    options_.progress(share);
}

void LoadProgress::askWhetherToGoOn() {
    if (!options_.cancelled || !options_.cancelled()) return;
    if (collada_) diagnostics_.fail(Code::Cancelled, collada_, {});
    diagnostics_.fail(Code::Cancelled, file_, 0, {});
}

void LoadProgress::finish() {
    if (options_.progress) options_.progress(1.0);
}

}  // namespace walkcycle
