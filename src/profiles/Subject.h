#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/ChannelTarget.h"
#include "loaders/Inspection.h"

namespace walkcycle {

// One <instance_geometry> or <instance_controller> that the scene shows, and what is beneath it.
struct Shown {
    XmlNode instance;
    int node = 0;                      // index into SceneGraph::skeleton.joints
    std::vector<XmlNode> controllers;  // the <skin>s and <morph>s on the way, outermost first
    XmlNode geometry;                  // nothing where the references lead nowhere
    XmlNode skin() const;              // the first of the skins
};

// What the rules of every target look at: the document's elements by name, what the scene shows of them, and where.
class Subject {
public:
    explicit Subject(const Inspection& inspection);

    XmlNode collada() const { return inspection_.collada; }
    const SceneGraph& scene() const { return inspection_.scene; }
    const Model& model() const { return inspection_.model; }

    // All elements of the document, or those of one name, in document order; also what nothing shows.
    const std::vector<XmlNode>& elements() const { return elements_; }
    const std::vector<XmlNode>& all(std::string_view name) const;
    const std::vector<Shown>& shown() const { return shown_; }

    // What an attribute ("" for the text) refers to; nothing where it leads nowhere, which the loader reported already.
    XmlNode follow(XmlNode from, const char* attribute) const;
    ChannelTarget targetOf(XmlNode channel) const { return findTarget(channel, sids_); }
    // The <source> (or <vertices>) that the <input> of that semantic names; nothing where there is none.
    XmlNode sourceOf(XmlNode parent, std::string_view semantic) const;

    const glm::dmat4& world(int node) const {
        return worlds_[static_cast<std::size_t>(node)];
    }  // at rest, as the file has it
    XmlNode element(int node) const { return scene().nodes[static_cast<std::size_t>(node)]; }
    int parent(int node) const { return scene().skeleton.joints[static_cast<std::size_t>(node)].parent; }

    // The numbers of a list, read once however many elements refer to it; what is no number counts as 0.
    const std::vector<double>& numbers(XmlNode list) const;
    // The same for lists that hold the same numbers, so that comparing many of them costs no more than reading them.
    int contents(XmlNode list) const;

    void report(Code code, XmlNode where, Diagnostics::Arguments arguments, int line = 0) const {
        inspection_.context.diagnostics.report(code, where, arguments, line);
    }

private:
    void addShown(const SceneGraph::Instance& instance);

    const Inspection& inspection_;
    std::vector<XmlNode> elements_;
    std::unordered_map<std::string_view, std::vector<XmlNode>> byName_;
    std::vector<Shown> shown_;
    std::vector<glm::dmat4> worlds_;

    struct ByContents {
        bool operator()(const std::vector<double>* a, const std::vector<double>* b) const { return *a < *b; }
    };
    mutable SidFinder sids_;
    mutable std::unordered_map<XmlNode, std::vector<double>> numbers_;
    mutable std::map<const std::vector<double>*, int, ByContents> contents_;
    mutable std::unordered_map<XmlNode, int> contentsOf_;
};

// ---- reading what the loader has judged already; what is no number counts as 0

std::vector<double> numbersOf(XmlNode node);  // of an element that is asked for once
std::vector<std::int32_t> integersOf(XmlNode node);
std::vector<std::string> wordsOf(XmlNode node);
int integerAttribute(XmlNode node, const char* attribute, int otherwise);

XmlNode inputOf(XmlNode parent, std::string_view semantic);  // the first <input> of that semantic
int offsetOf(XmlNode input);
int indicesPerCorner(XmlNode primitive);  // one more than the largest offset
XmlNode accessorOf(XmlNode source);
int strideOf(XmlNode source);

// A <matrix>, <bind_shape_matrix> or 16 numbers of a list.
glm::dmat4 matrixOf(const std::vector<double>& numbers, std::size_t first = 0);
bool isSame(const glm::dmat4& a,
            const glm::dmat4& b);  // up to what single precision and six digits leave open
bool isIdentity(const glm::dmat4& matrix);

// How many vertices of a <skin> follow more joints than `limit` (with a weight that is not zero), and the most that
// one follows.
struct Crowding {
    std::size_t vertices = 0, most = 0;
};
Crowding verticesOver(const Subject& subject, XmlNode skin, std::size_t limit);

// How a message may call a node or any other element: its id, name or sid.
std::string nameOf(XmlNode element);
// "png" of "maps/Skin.PNG"
std::string extensionOf(std::string_view path);

bool isOneOf(XmlNode element, std::initializer_list<std::string_view> names);

}  // namespace walkcycle
