#include "profiles/Subject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "animation/RowMajor.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

// The root and every element below it, in document order.
std::vector<XmlNode> inDocumentOrder(XmlNode root) {
    std::vector<XmlNode> all{root};
    for (XmlNode element : root.descendants()) all.push_back(element);
    return all;
}

}  // namespace

XmlNode ShownMesh::skin() const {
    for (const XmlNode controller : controllers)
        if (controller.is("skin")) return controller;
    return {};
}

Subject::Subject(const Inspection& inspection)
    : inspection_(inspection), elements_(inDocumentOrder(inspection.collada)) {
    for (const XmlNode element : elements_) byName_[element.name()].push_back(element);
    const SceneGraph& scene = inspection.scene;
    for (std::size_t i = 0; i < scene.stacks.size(); ++i) {
        const int parent = scene.skeleton.joints[i].parent;
        const glm::dmat4 local = scene.outer[i] * scene.stacks[i].toMatrix();
        worlds_.push_back(parent == kNoParent ? local : world(parent) * local);
    }
    for (const SceneGraph::Instance& instance : scene.geometries) addShown(instance);
    for (const SceneGraph::Instance& instance : scene.controllers) addShown(instance);
}

void Subject::addShown(const SceneGraph::Instance& instance) {
    ShownMesh shown{instance.element, instance.node, {}, {}};
    std::unordered_set<XmlNode> seen;  // a controller may lead back to itself
    XmlNode target = follow(instance.element, "url");
    while (target.is("controller") && seen.insert(target).second) {
        const XmlNode skin = target.child("skin");
        const XmlNode deformer = skin ? skin : target.child("morph");
        if (!deformer) break;
        shown.controllers.push_back(deformer);
        target = follow(deformer, "source");
    }
    if (target.is("geometry")) shown.geometry = target;
    shown_.push_back(std::move(shown));
}

const std::vector<XmlNode>& Subject::all(std::string_view name) const {
    static const std::vector<XmlNode> kNone;
    const auto found = byName_.find(name);
    return found == byName_.end() ? kNone : found->second;
}

XmlNode Subject::follow(XmlNode from, const char* attribute) const {
    if (!from) return {};
    const std::string uri = *attribute ? std::string(from.attribute(attribute)) : from.text();
    const std::size_t hash = uri.find('#');
    if (hash == std::string::npos) return from.elementById(uri);
    // References to other documents are not followed, because no program of the profiles reads them.
    return hash == 0 ? inspection_.context.documents.resolve(from, uri) : XmlNode();
}

XmlNode Subject::sourceOf(XmlNode parent, std::string_view semantic) const {
    return follow(inputOf(parent, semantic), "source");
}

const std::vector<double>& Subject::numbers(XmlNode list) const {
    const auto [entry, isNew] = numbers_.try_emplace(list);
    if (isNew) entry->second = numbersOf(list);
    return entry->second;
}

int Subject::contents(XmlNode list) const {
    const auto [entry, isNew] = contentsOf_.try_emplace(list, 0);
    if (isNew)
        entry->second =
            contents_.try_emplace(&numbers(list), static_cast<int>(contents_.size())).first->second;
    return entry->second;
}

std::vector<double> numbersOf(XmlNode node) {
    std::vector<double> values;
    std::vector<NumberFault> faults;
    std::string joined;
    parseNumbers(node.rawText(joined), values, faults);
    return values;
}

std::vector<std::int32_t> integersOf(XmlNode node) {
    std::vector<std::int32_t> values;
    std::vector<NumberFault> faults;
    std::string joined;
    parseNumbers(node.rawText(joined), values, faults);
    return values;
}

std::vector<std::string> wordsOf(XmlNode node) {
    std::string joined;
    const std::vector<std::string_view> words = splitWords(node.rawText(joined));
    return {words.begin(), words.end()};
}

int integerAttribute(XmlNode node, const char* attribute, int otherwise) {
    std::int32_t value = 0;
    return node.has(attribute) && parseNumber(node.attribute(attribute), value) ? value : otherwise;
}

XmlNode inputOf(XmlNode parent, std::string_view semantic) {
    for (const XmlNode input : parent.children("input"))
        if (input.attribute("semantic") == semantic) return input;
    return {};
}

int offsetOf(XmlNode input) {
    constexpr int kLargestOffset = 1 << 20;  // more than any file needs; sums of offsets do not overflow
    return std::clamp(integerAttribute(input, "offset", 0), 0, kLargestOffset);
}

int indicesPerCorner(XmlNode primitive) {
    int largest = 0;
    for (const XmlNode input : primitive.children("input")) largest = std::max(largest, offsetOf(input));
    return largest + 1;
}

XmlNode accessorOf(XmlNode source) {
    return source.child("technique_common").child("accessor");
}

int strideOf(XmlNode source) {
    return integerAttribute(accessorOf(source), "stride", 1);
}

glm::dmat4 matrixOf(const std::vector<double>& numbers, std::size_t first) {
    if (numbers.size() < 16 || first > numbers.size() - 16) return glm::dmat4(1.0);
    return affineFromRows<double>(numbers.data() + first);
}

bool isSame(const glm::dmat4& a, const glm::dmat4& b) {
    double largest = 1.0, difference = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            largest = std::max(largest, std::abs(a[column][row]));
            difference = std::max(difference, std::abs(a[column][row] - b[column][row]));
        }
    return difference <= 1e-4 * largest;
}

bool isIdentity(const glm::dmat4& matrix) {
    return isSame(matrix, glm::dmat4(1.0));
}

ManyInfluences verticesWithMoreJoints(const Subject& subject, XmlNode skin, std::size_t limit) {
    const XmlNode element = skin.child("vertex_weights");
    const std::vector<double>& weights =
        subject.numbers(subject.sourceOf(element, "WEIGHT").child("float_array"));
    const auto offset = static_cast<std::size_t>(offsetOf(inputOf(element, "WEIGHT")));
    const auto stride = static_cast<std::size_t>(indicesPerCorner(element));
    const std::vector<std::int32_t> indices = integersOf(element.child("v"));
    ManyInfluences many;
    std::size_t pair = 0;
    for (const std::int32_t count : integersOf(element.child("vcount"))) {
        std::size_t joints = 0;
        for (std::int32_t i = 0; i < count && (pair + 1) * stride <= indices.size(); ++i, ++pair) {
            const auto index = static_cast<std::size_t>(std::max(0, indices[pair * stride + offset]));
            joints += index < weights.size() && weights[index] > 0.0;
        }
        many.vertices += joints > limit;
        many.most = std::max(many.most, joints);
    }
    return many;
}

std::string nameOf(XmlNode element) {
    for (const char* attribute : {"id", "name", "sid"})
        if (!element.attribute(attribute).empty()) return std::string(element.attribute(attribute));
    return "";
}

std::string extensionOf(std::string_view path) {
    const std::size_t dot = path.find_last_of("./\\");
    if (dot == std::string_view::npos || path[dot] != '.') return "";
    std::string extension(path.substr(dot + 1));
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

bool isOneOf(XmlNode element, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), element.name()) != names.end();
}

}  // namespace walkcycle
