#include "loaders/controllers/SkinLoader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <glm/gtc/matrix_inverse.hpp>

#include "animation/RowMajor.h"
#include "loaders/controllers/WeightsReader.h"
#include "loaders/quirks/Dialect.h"
#include "loaders/sources/Inputs.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

// Whether the matrix has (nearly) no inverse, relative to its own size: a matrix that scales to a small unit
// has one.
bool isSingular(const glm::mat4& matrix) {
    const double size = std::max({glm::length(glm::dvec3(matrix[0])), glm::length(glm::dvec3(matrix[1])),
                                  glm::length(glm::dvec3(matrix[2]))});
    return !(std::abs(glm::determinant(glm::dmat3(matrix))) > 1e-9 * size * size * size);
}

glm::mat4 readBindShapeMatrix(XmlNode skin, const LoadContext& context) {
    const XmlNode element = skin.child("bind_shape_matrix");
    if (!element) return glm::mat4(1.0f);
    const std::vector<double> values = readDoubles(element, context.diagnostics, NumberFaults::Error);
    if (values.size() != 16) {
        context.diagnostics.report(Code::CountMismatch, element,
                                   {"bind_shape_matrix", "16", "values", std::to_string(values.size())});
        return glm::mat4(1.0f);
    }
    const glm::mat4 matrix = affineFromRows<float>(values.data());
    if (isSingular(matrix))
        context.diagnostics.report(Code::SingularBindMatrix, element, {"bind shape matrix"});
    return matrix;
}

void readInverseBindMatrices(const Input& input, const LoadContext& context, SkinData& data) {
    const auto source = input.source ? context.sources.floats(input.source, NumberFaults::Error) : nullptr;
    if (!source) return;
    if (source->width != 16) {
        context.diagnostics.report(
            Code::CountMismatch, source->element,
            {"source of INV_BIND_MATRIX", "16", "values an entry", std::to_string(source->width)});
        return;
    }
    std::optional<std::size_t> singular;
    for (std::size_t i = 0; i < source->count(); ++i) {
        data.inverseBindMatrices.push_back(affineFromRows<float>((*source)[i]));
        if (!singular && isSingular(data.inverseBindMatrices.back())) singular = i;
    }
    if (singular)
        context.diagnostics.report(Code::SingularBindMatrix, source->array, {"inverse bind matrix"},
                                   source->lineOf(*singular));
}

void readJointNames(const Input& input, const LoadContext& context, SkinData& data) {
    const auto names = input.source ? context.sources.names(input.source, data.namesAreIds) : nullptr;
    if (!names) return;
    if (names->width != 1)
        context.diagnostics.report(Code::SourceWidth, input.element,
                                   {input.semantic, std::to_string(names->width), "1"});
    data.jointNames = names->values;
    data.nameSource = names;
    std::unordered_set<std::string_view> seen;
    int repeated = 0;  // lines are searched for the first few only
    for (std::size_t i = 0; i < data.jointNames.size(); ++i)
        if (!seen.insert(data.jointNames[i]).second)
            context.diagnostics.report(Code::DuplicateJoint, names->array, {data.jointNames[i]},
                                       ++repeated <= kMostLinesLookedFor ? names->lineOf(i) : 0);
}

// The joint indices of <vertex_weights> are indices into the list that it names itself. Reports it if
// <joints> names another list.
void checkJointLists(XmlNode joints, XmlNode weights, const LoadContext& context) {
    std::string_view named[2];
    const XmlNode elements[2] = {joints, weights};
    for (int i = 0; i < 2; ++i)
        for (XmlNode input : elements[i].children("input"))
            if (input.attribute("semantic") == "JOINT") named[i] = trim(input.attribute("source"));
    const auto lead = [&](int i) { return context.documents.resolve(elements[i], named[i]); };
    if (named[0].empty() || named[1].empty() || named[0] == named[1]) return;
    if (lead(0) && lead(1) && !(lead(0) == lead(1)))
        context.diagnostics.report(Code::JointListsDiffer, weights,
                                   {std::string(named[1]), std::string(named[0])});
}

// The inverse of the joint's model transform at rest: used if the file has no inverse bind matrices.
glm::mat4 restInverseBind(const SceneGraph& scene, int joint) {
    glm::dmat4 world(1.0);
    for (; joint != kNoParent; joint = scene.skeleton.joints[static_cast<std::size_t>(joint)].parent)
        world = glm::dmat4(scene.skeleton.joints[static_cast<std::size_t>(joint)].localBindTransform) * world;
    return std::abs(glm::determinant(world)) > 1e-30 ? glm::mat4(glm::inverse(world)) : glm::mat4(1.0f);
}

// Sets Skin::placedBy (the quirk skin-by-node). `ancestor`: the nearest common ancestor of the node and the
// joints.
void placeByNode(const SceneGraph::Instance& instance, int ancestor, const LoadContext& context, Skin& skin) {
    skin.placedBy = instance.node;
    skin.placedRelativeTo = ancestor;
    const std::string node(instance.element.parent().attribute("name"));
    context.diagnostics.report(Code::SkinNodeApplied, instance.element,
                               {node, context.dialects.of(instance.element).authoringTool()});
    context.dialects.note(Quirk::SkinByNode, instance.element);
}

}  // namespace

bool loadSkin(XmlNode skin, std::size_t positionCount, const LoadContext& context, Model& model,
              SkinData& data) {
    data.skin = skin;
    data.bindShapeMatrix = readBindShapeMatrix(skin, context);
    const XmlNode joints = skin.child("joints");
    if (!joints) context.diagnostics.report(Code::MissingElement, skin, {"skin", "joints"});
    bool hasNames = false;
    for (const Input& input : readInputs(joints, context.documents, context.diagnostics)) {
        if (input.semantic == "JOINT") readJointNames(input, context, data), hasNames = true;
        if (input.semantic == "INV_BIND_MATRIX") readInverseBindMatrices(input, context, data);
    }
    if (joints && !hasNames)
        context.diagnostics.report(Code::MissingElement, joints, {"joints", "input semantic=\"JOINT\""});
    if (data.inverseBindMatrices.empty() && hasNames)
        context.diagnostics.report(Code::InverseBindMissing, joints, {});
    else if (data.inverseBindMatrices.size() != data.jointNames.size())
        context.diagnostics.report(
            Code::JointMatrixMismatch, joints,
            {std::to_string(data.jointNames.size()), std::to_string(data.inverseBindMatrices.size())});

    const XmlNode weights = skin.child("vertex_weights");
    if (!weights) context.diagnostics.report(Code::MissingElement, skin, {"skin", "vertex_weights"});
    if (!weights || data.jointNames.empty()) return false;
    checkJointLists(joints, weights, context);
    data.influences = static_cast<int>(model.influences.size());
    model.influences.push_back(readWeights(weights, positionCount, data.jointNames.size(), context));
    return true;
}

Skin bindSkin(const SkinData& data, const SceneGraph::Instance& instance, JointFinder& joints,
              SceneGraph& scene, const LoadContext& context) {
    Skin skin;
    const std::vector<int> roots = joints.skeletonRoots(instance.element);
    int shared = instance.node, missing = 0;
    for (std::size_t i = 0; i < data.jointNames.size(); ++i) {
        const std::string& name = data.jointNames[i];
        int joint = joints.find(name, data.namesAreIds, roots, instance.node, data.skin);
        const bool found = joint != kNoParent;
        if (!found) {
            context.diagnostics.report(Code::JointNotFound, data.nameSource->array, {name},
                                       ++missing <= kMostLinesLookedFor ? data.nameSource->lineOf(i) : 0);
            joint = instance.node;  // its vertices follow the skin's node, like vertices without weights
        } else {
            shared = joints.nearestCommonAncestor(shared, joint);
        }
        skin.joints.push_back(joint);
        glm::mat4 inverseBind(1.0f);
        if (found && i < data.inverseBindMatrices.size()) inverseBind = data.inverseBindMatrices[i];
        if (found && data.inverseBindMatrices.empty()) inverseBind = restInverseBind(scene, joint);
        // In double: far from the origin both matrices are large and nearly cancel out.
        skin.bindMatrices.emplace_back(glm::dmat4(inverseBind) * glm::dmat4(data.bindShapeMatrix));
    }
    skin.joints.push_back(instance.node);
    skin.bindMatrices.push_back(data.bindShapeMatrix);
    if (shared != instance.node && context.dialects.follows(Quirk::SkinByNode, instance.element))
        placeByNode(instance, shared, context, skin);
    return skin;
}

}  // namespace walkcycle
