#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/Inspection.h"
#include "loaders/curves/ChannelTarget.h"

namespace walkcycle {

// One <instance_geometry> or <instance_controller> of the shown scene, with its controllers and its geometry.
struct ShownMesh {
    XmlNode instance;
    int node = 0;                      // index into SceneGraph::skeleton.joints
    std::vector<XmlNode> controllers;  // its <skin>s and <morph>s, outermost first
    XmlNode geometry;                  // null if the references do not lead to one
    XmlNode skin() const;              // the outermost <skin>; null if there is none
};

// A document in the form that the rules of all profiles use: its elements by name, and the meshes of the shown scene.
class Subject {
public:
    explicit Subject(const Inspection& inspection);

    XmlNode collada() const { return inspection_.collada; }
    const SceneGraph& scene() const { return inspection_.scene; }
    const Model& model() const { return inspection_.model; }

    // All elements of the document, or all of one name, in document order. They include elements that the scene does
    // not show.
    const std::vector<XmlNode>& elements() const { return elements_; }
    const std::vector<XmlNode>& all(std::string_view name) const;
    const std::vector<ShownMesh>& shown() const { return shown_; }  // the meshes of the shown scene

    // The element that an attribute ("": the element's text) refers to. Null if there is none; the loader has
    // reported that already.
    XmlNode follow(XmlNode from, const char* attribute) const;
    // The element that a <channel> animates.
    ChannelTarget targetOf(XmlNode channel) const { return findTarget(channel, sids_); }
    // The <source> (or <vertices>) that the <input> of that semantic names; null if there is none.
    XmlNode sourceOf(XmlNode parent, std::string_view semantic) const;

    // A node is an index into SceneGraph::skeleton.joints. Its transform to the scene is at rest, in the file's axes
    // and unit.
    const glm::dmat4& world(int node) const { return worlds_[static_cast<std::size_t>(node)]; }
    XmlNode element(int node) const { return scene().nodes[static_cast<std::size_t>(node)]; }
    int parent(int node) const { return scene().skeleton.joints[static_cast<std::size_t>(node)].parent; }

    // The numbers of a list, parsed once and kept. A word that is not a number counts as 0.
    const std::vector<double>& numbers(XmlNode list) const;
    // A number for the contents of a list: equal for lists of equal numbers, different for others. Comparing these
    // numbers is faster than comparing the lists.
    int contents(XmlNode list) const;

    // Adds a diagnostic about an element; `line` overrides the element's own line.
    void report(Code code, XmlNode where, Diagnostics::Arguments arguments, int line = 0) const {
        inspection_.context.diagnostics.report(code, where, arguments, line);
    }

private:
    void addShown(const SceneGraph::Instance& instance);

    const Inspection& inspection_;
    std::vector<XmlNode> elements_;
    std::unordered_map<std::string_view, std::vector<XmlNode>> byName_;
    std::vector<ShownMesh> shown_;
    std::vector<glm::dmat4> worlds_;

    struct ByContents {
        bool operator()(const std::vector<double>* a, const std::vector<double>* b) const { return *a < *b; }
    };
    mutable SidFinder sids_;
    mutable std::unordered_map<XmlNode, std::vector<double>> numbers_;
    mutable std::map<const std::vector<double>*, int, ByContents> contents_;
    mutable std::unordered_map<XmlNode, int> contentsOf_;
};

// ---- parsing without messages, because the loader has reported the faults already

// The numbers or the words of an element's text. A word that is not a number counts as 0. Nothing is kept, so for lists
// that are needed more than once use Subject::numbers().
std::vector<double> numbersOf(XmlNode node);
std::vector<std::int32_t> integersOf(XmlNode node);
std::vector<std::string> wordsOf(XmlNode node);

// The value of an attribute; `otherwise` if there is none or it is not an integer.
int integerAttribute(XmlNode node, const char* attribute, int otherwise);

XmlNode inputOf(XmlNode parent, std::string_view semantic);  // the first <input> of that semantic
int offsetOf(XmlNode input);                                 // 0 if there is none
int indicesPerCorner(XmlNode primitive);  // one more than the largest offset of its <input>s
XmlNode accessorOf(XmlNode source);       // null if there is none
int strideOf(XmlNode source);             // numbers per entry of the accessor; 1 if there is none

// The matrix whose 16 numbers begin at `first`, row by row; the identity if there are fewer.
glm::dmat4 matrixOf(const std::vector<double>& numbers, std::size_t first = 0);

// Whether two matrices are equal but for 1e-4 of their largest number (or of 1), which is more than the error of
// numbers that were written with six digits.
bool isSame(const glm::dmat4& a, const glm::dmat4& b);
bool isIdentity(const glm::dmat4& matrix);

// The number of vertices of a <skin> that have more than `limit` influences (with weights over zero), and the largest
// number of influences of any vertex.
struct ManyInfluences {
    std::size_t vertices = 0, most = 0;
};
ManyInfluences verticesWithMoreJoints(const Subject& subject, XmlNode skin, std::size_t limit);

// The name of an element in messages: its id, else its name, else its sid.
std::string nameOf(XmlNode element);
// The extension in lower case, without the dot: "png" for "maps/Skin.PNG".
std::string extensionOf(std::string_view path);

bool isOneOf(XmlNode element, std::initializer_list<std::string_view> names);

}  // namespace walkcycle
