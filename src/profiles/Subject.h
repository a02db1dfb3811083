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
    XmlNode skin() const;              // the outermost one; null if there is none
};

// A document as the rules of all profiles look at it: its elements by name, and the meshes of the shown
// scene.
class Subject {
public:
    explicit Subject(const Inspection& inspection);

    XmlNode collada() const { return inspection_.collada; }
    const SceneGraph& scene() const { return inspection_.scene; }
    const Model& model() const { return inspection_.model; }

    // All elements of the document, or all of one name, in document order, whether the scene shows them or
    // not.
    const std::vector<XmlNode>& elements() const { return elements_; }
    const std::vector<XmlNode>& all(std::string_view name) const;
    const std::vector<ShownMesh>& shown() const { return shown_; }

    // The element that an attribute ("": the element's text) refers to. Null if there is none; the loader has
    // reported that already.
    XmlNode follow(XmlNode from, const char* attribute) const;
    ChannelTarget targetOf(XmlNode channel) const { return findTarget(channel, sids_); }
    // The <source> (or <vertices>) that the <input> of that semantic names; null if there is none.
    XmlNode sourceOf(XmlNode parent, std::string_view semantic) const;

    const glm::dmat4& world(int node) const {
        return worlds_[static_cast<std::size_t>(node)];
    }  // at rest, in the file's axes and unit
    XmlNode element(int node) const { return scene().nodes[static_cast<std::size_t>(node)]; }
    int parent(int node) const { return scene().skeleton.joints[static_cast<std::size_t>(node)].parent; }

    // The numbers of a list, parsed once and kept. A word that is not a number counts as 0.
    const std::vector<double>& numbers(XmlNode list) const;
    // A number that lists have in common if their contents are equal, so that comparing many lists costs no
    // more than parsing them.
    int contents(XmlNode list) const;

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

// ---- parsing without messages, which the loader has given already: a word that is not a number counts as 0

std::vector<double> numbersOf(XmlNode node);  // not kept: for elements that are needed once
std::vector<std::int32_t> integersOf(XmlNode node);
std::vector<std::string> wordsOf(XmlNode node);
int integerAttribute(XmlNode node, const char* attribute, int otherwise);

XmlNode inputOf(XmlNode parent, std::string_view semantic);  // the first <input> of that semantic
int offsetOf(XmlNode input);
int indicesPerCorner(XmlNode primitive);  // one more than the largest offset
XmlNode accessorOf(XmlNode source);
int strideOf(XmlNode source);

// The matrix whose 16 numbers begin at `first`, row by row; the identity if there are fewer.
glm::dmat4 matrixOf(const std::vector<double>& numbers, std::size_t first = 0);
bool isSame(const glm::dmat4& a,
            const glm::dmat4& b);  // within the error of single precision and six digits
bool isIdentity(const glm::dmat4& matrix);

// How many vertices of a <skin> follow more than `limit` joints (with weights over zero), and how many joints
// the worst of them follows.
struct ManyInfluences {
    std::size_t vertices = 0, most = 0;
};
ManyInfluences verticesWithMoreJoints(const Subject& subject, XmlNode skin, std::size_t limit);

// What messages call an element: its id, else its name, else its sid.
std::string nameOf(XmlNode element);
// "png" of "maps/Skin.PNG"
std::string extensionOf(std::string_view path);

bool isOneOf(XmlNode element, std::initializer_list<std::string_view> names);

}  // namespace walkcycle
