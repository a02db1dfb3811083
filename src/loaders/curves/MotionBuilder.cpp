#include "loaders/curves/MotionBuilder.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loaders/context/AssetReader.h"

namespace walkcycle {

namespace {

struct Part {
    std::size_t first = 0, count = 0;
};

// The numbers of an element (which has `width` of them) that the member or the indices of a target name.
// Nothing if it has no such numbers.
std::optional<Part> partOf(const ChannelTarget& target, std::size_t width, bool isMatrix) {
    const std::vector<int>& indices = target.indices;
    std::size_t first = 0;
    if (indices.size() == 2) {  // (column)(row)
        if (!isMatrix || indices[0] > 3 || indices[1] > 3) return std::nullopt;
        first = static_cast<std::size_t>(indices[1] * 4 + indices[0]);
    } else if (indices.size() == 1) {
        first = static_cast<std::size_t>(indices[0]);
    } else if (const auto index = memberIndex(target.member)) {
        first = width == 1 ? 0 : static_cast<std::size_t>(*index);
    } else {
        if (!target.member.empty() && width > 1 && !isMatrix) return std::nullopt;
        return Part{0, width};
    }
    if (first >= width) return std::nullopt;
    return Part{first, 1};
}

}  // namespace

MotionBuilder::MotionBuilder(const SceneGraph& scene, const AnimationTargets& targets,
                             const LoadContext& context, Model& model)
    : scene_(scene),
      context_(context),
      model_(model),
      samplers_(context),
      parameters_(scene, targets, context, model) {}

void MotionBuilder::add(XmlNode channel) {
    channels_.push_back(channel);
    const XmlNode sampler = context_.documents.follow(channel, "source", "sampler");
    const int curve = sampler ? samplers_.read(sampler) : -1;
    if (curve < 0) return;
    const ChannelTarget target = findTarget(channel, sids_);
    if (target.element && target.element.parent().is("node") && !target.element.is("node")) {
        const auto [first, last] = scene_.occurrences.equal_range(target.element.parent());
        if (first != last && !target.element.is("visibility")) return bindNode(channel, target, curve);
    }
    bindParameters(channel, target, curve);
}

void MotionBuilder::bindNode(XmlNode channel, const ChannelTarget& target, int curve) {
    const auto curveWidth = samplers_.curves()[static_cast<std::size_t>(curve)].width;
    const std::string text(channel.attribute("target"));
    const auto [firstJoint, lastJoint] = scene_.occurrences.equal_range(target.element.parent());
    for (auto joint = firstJoint; joint != lastJoint; ++joint) {
        const auto& elements = scene_.stacks[static_cast<std::size_t>(joint->second)].elements;
        const auto element = std::find_if(elements.begin(), elements.end(), [&](const TransformElement& e) {
            return e.element == target.element;
        });
        if (element == elements.end())
            return context_.diagnostics.report(Code::TargetNotMoved, channel,
                                               {text, std::string(target.element.name())});
        const auto width = static_cast<std::size_t>(element->valueCount());
        auto part = partOf(target, width, element->kind == TransformElement::Kind::Matrix);
        if (!part)
            return context_.diagnostics.report(Code::TargetMemberUnknown, channel,
                                               {text, std::string(target.element.name())});
        // Exporters often animate a whole <rotate> by its angle alone.
        if (part->count == 4 && curveWidth == 1) part = Part{3, 1};
        if (curveWidth > 16 || (part->count > 1 && part->count != curveWidth))
            return context_.diagnostics.report(
                Code::TargetWidthMismatch, channel,
                {text, std::to_string(part->count), std::to_string(curveWidth)});
        if (part->count == 1 && curveWidth != 1 && curveWidth != width)
            reportFirstTaken(channel, curveWidth, 1);
        CurveBinding binding;
        binding.component = part->count == 1 && curveWidth == width ? part->first : 0;
        binding.element = static_cast<std::size_t>(element - elements.begin());
        binding.first = part->first;
        binding.count = part->count;
        binding.channel = channelCount() - 1;
        bindInOwnSpace(channel, *element, joint->second, curve, binding);
    }
}

// Binds a curve in the unit and axes of the <asset> of its <animation>. What that calls Z may be Y in the
// document.
void MotionBuilder::bindInOwnSpace(XmlNode channel, const TransformElement& element, int joint, int curve,
                                   const CurveBinding& binding) {
    const XmlNode collada = channel.root();
    const glm::dmat4 conversion = assetConversion(channel, collada, model_.asset, collada);
    if (element.kind != TransformElement::Kind::Translate || conversion == glm::dmat4(1.0)) {
        jointBindings_.push_back({joint, curve, binding});
        return;
    }
    for (std::size_t i = 0; i < binding.count; ++i) {
        const int from = static_cast<int>(binding.first + i);
        CurveBinding part = binding;
        part.component = binding.component + i;
        part.count = 1;
        for (int to = 0; to < 3; ++to) {
            if (conversion[from][to] == 0.0) continue;  // the axes are swapped, never mixed
            part.first = static_cast<std::size_t>(to);
            part.scale = conversion[from][to];
            jointBindings_.push_back({joint, curve, part});
        }
    }
}

void MotionBuilder::bindParameters(XmlNode channel, const ChannelTarget& target, int curve) {
    const std::size_t curveWidth = samplers_.curves()[static_cast<std::size_t>(curve)].width;
    const std::string text(channel.attribute("target"));
    const auto found = parameters_.find(target);
    if (found.empty() && !target.element)
        return context_.diagnostics.report(Code::TargetNotFound, channel, {text, target.lookedFor});
    if (found.empty())
        return context_.diagnostics.report(Code::TargetNotMoved, channel,
                                           {text, std::string(target.element.name())});
    for (const std::vector<int>& numbers : found) {
        const auto part = partOf(target, numbers.size(), false);
        if (!part)
            return context_.diagnostics.report(
                Code::TargetMemberUnknown, channel,
                {text, std::string((target.element ? target.element : target.root).name())});
        const bool isWhole = part->count == 1 && curveWidth == numbers.size();
        if (!isWhole && curveWidth > part->count) reportFirstTaken(channel, curveWidth, part->count);
        for (std::size_t i = 0; i < std::min(part->count, curveWidth); ++i) {
            ParameterMotion::Binding binding;
            binding.component = isWhole ? part->first : i;
            binding.channel = channelCount() - 1;
            parameterBindings_.push_back({numbers[part->first + i], curve, binding});
        }
    }
}

// Reports that a sampler has more numbers than its target, so that the first ones are taken.
void MotionBuilder::reportFirstTaken(XmlNode channel, std::size_t given, std::size_t taken) {
    context_.diagnostics.report(Code::SourceWidth, channel,
                                {"OUTPUT", std::to_string(given), std::to_string(taken)});
}

std::shared_ptr<Motion> MotionBuilder::finish(const std::function<bool(int, int)>& together) {
    if (jointBindings_.empty() && parameterBindings_.empty()) return nullptr;
    auto motion = std::make_shared<Motion>(std::move(samplers_.curves()), scene_);
    for (const Parameter& parameter : model_.parameters)
        motion->restParameters.push_back(parameter.restValue);
    addJoints(*motion, together);
    addParameters(*motion);
    return motion;
}

void MotionBuilder::addJoints(Motion& motion, const std::function<bool(int, int)>& together) {
    std::stable_sort(jointBindings_.begin(), jointBindings_.end(),
                     [](const JointBinding& a, const JointBinding& b) { return a.joint < b.joint; });
    for (const JointBinding& next : jointBindings_) {
        if (motion.joints.empty() || motion.joints.back().joint != next.joint) {
            const auto joint = static_cast<std::size_t>(next.joint);
            JointMotion& added = motion.joints.emplace_back();
            added.joint = next.joint;
            added.outer = scene_.outer[joint];
            for (const TransformElement& e : scene_.stacks[joint].elements)
                added.stack.push_back({e.kind, e.values});
        }
        motion.joints.back().bindings.push_back(next.binding);
        motion.joints.back().bindings.back().curve = &motion.curves()[static_cast<std::size_t>(next.curve)];
    }
    for (JointMotion& joint : motion.joints) {
        joint.orderRivals();
        reportRivals(joint, together);
    }
}

void MotionBuilder::reportRivals(const JointMotion& motion, const std::function<bool(int, int)>& together) {
    const std::vector<CurveBinding>& all = motion.bindings;
    for (std::size_t i = 1; i < all.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (overlap(all[i], all[k]) && all[i].curve->start() < all[k].curve->end() &&
                together(all[i].channel, all[k].channel)) {
                const XmlNode channel =
                    channels_[static_cast<std::size_t>(std::max(all[i].channel, all[k].channel))];
                context_.diagnostics.report(Code::ChannelDuplicateTarget, channel,
                                            {std::string(channel.attribute("target"))});
                return;
            }
}

void MotionBuilder::addParameters(Motion& motion) {
    std::stable_sort(
        parameterBindings_.begin(), parameterBindings_.end(),
        [](const ParameterBinding& a, const ParameterBinding& b) { return a.parameter < b.parameter; });
    for (const ParameterBinding& next : parameterBindings_) {
        if (motion.parameters.empty() || motion.parameters.back().parameter != next.parameter) {
            ParameterMotion& added = motion.parameters.emplace_back();
            added.parameter = next.parameter;
            added.restValue = model_.parameters[static_cast<std::size_t>(next.parameter)].restValue;
        }
        motion.parameters.back().bindings.push_back(next.binding);
        motion.parameters.back().bindings.back().curve =
            &motion.curves()[static_cast<std::size_t>(next.curve)];
    }
    for (ParameterMotion& parameter : motion.parameters) parameter.orderRivals();
}

}  // namespace walkcycle
