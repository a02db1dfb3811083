#include "loaders/WeightsReader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "loaders/NumberParser.h"

namespace walkcycle {
namespace {

constexpr float kSumTolerance = 0.02f;  // exporters round to two or three digits

// Where the numbers of one influence stand in <v>.
struct Layout {
    std::size_t jointOffset = 0, weightOffset = 0, stride = 1;
    std::shared_ptr<const FloatSource> weights;
};

// What was met on the way, to be said once.
struct Findings {
    std::size_t negative = 0, unnormalised = 0, unweighted = 0;
    float worstSum = 1.0f;
};

std::string format(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4).ptr;
    return {text, end};
}

bool readLayout(XmlNode vertexWeights, const LoadContext& context, Layout& layout) {
    bool hasJoints = false;
    for (const Input& input : readInputs(vertexWeights, context.documents, context.diagnostics)) {
        const auto offset = static_cast<std::size_t>(input.offset);
        layout.stride = std::max(layout.stride, offset + 1);
        if (input.semantic == "JOINT") {
            layout.jointOffset = offset;
            hasJoints = true;
        } else if (input.semantic == "WEIGHT" && layout.weights) {
            context.diagnostics.report(Code::WeightSetIgnored, input.element, {});
        } else if (input.semantic == "WEIGHT" && input.source) {
            layout.weightOffset = offset;
            layout.weights = context.sources.floats(input.source, Numbers::Error);
        }
    }
    if (hasJoints && layout.weights) return true;
    context.diagnostics.report(
        Code::MissingElement, vertexWeights,
        {"vertex_weights", hasJoints ? "input semantic=\"WEIGHT\"" : "input semantic=\"JOINT\""});
    return false;
}

class Reader {
public:
    Reader(XmlNode element, const LoadContext& context, const Layout& layout, std::size_t jointCount)
        : element_(element), context_(context), layout_(layout), jointCount_(jointCount) {}

    // The influences of one position: `count` groups of numbers at `group`.
    void add(const std::int32_t* group, std::size_t count, Influences& out) {
        const std::size_t begin = out.influences.size();
        for (std::size_t i = 0; i < count; ++i, group += layout_.stride) addOne(group, out);
        normalise(out, begin);
        out.first.push_back(static_cast<std::uint32_t>(out.influences.size()));
    }

    void addUnweighted(Influences& out) {
        out.influences.push_back({static_cast<std::uint32_t>(jointCount_), 1.0f});
        out.first.push_back(static_cast<std::uint32_t>(out.influences.size()));
    }

    void report() const {
        Diagnostics& diagnostics = context_.diagnostics;
        if (found_.negative)
            diagnostics.report(Code::NegativeWeight, element_, {std::to_string(found_.negative)});
        if (found_.unnormalised)
            diagnostics.report(Code::WeightsNotNormalised, element_,
                               {std::to_string(found_.unnormalised), format(found_.worstSum)});
        if (found_.unweighted)
            diagnostics.report(Code::UnweightedVertices, element_, {std::to_string(found_.unweighted)});
    }

private:
    void addOne(const std::int32_t* group, Influences& out) {
        const std::int32_t joint = group[layout_.jointOffset], weight = group[layout_.weightOffset];
        if (weight < 0 || static_cast<std::size_t>(weight) >= layout_.weights->count()) {
            outOfRange("weight", weight, layout_.weights->count());
            return;
        }
        if (joint < -1 || (joint >= 0 && static_cast<std::size_t>(joint) >= jointCount_)) {
            outOfRange("joint", joint, jointCount_);
            return;
        }
        const float value = (*layout_.weights)[static_cast<std::size_t>(weight)][0];
        if (value < 0.0f) ++found_.negative;
        if (value > 0.0f)
            out.influences.push_back(
                {joint < 0 ? static_cast<std::uint32_t>(jointCount_) : static_cast<std::uint32_t>(joint),
                 value});
    }

    void outOfRange(const char* what, std::int32_t index, std::size_t count) const {
        context_.diagnostics.report(Code::InfluenceOutOfRange, element_,
                                    {what, std::to_string(index), std::to_string(count)},
                                    element_.child("v").line());
    }

    void normalise(Influences& out, std::size_t begin) {
        float sum = 0.0f;
        for (std::size_t i = begin; i < out.influences.size(); ++i) sum += out.influences[i].weight;
        if (out.influences.size() == begin || !(sum > 1e-12f) || !std::isfinite(sum)) {
            out.influences.resize(begin);
            out.influences.push_back({static_cast<std::uint32_t>(jointCount_), 1.0f});
            ++found_.unweighted;
            return;
        }
        if (std::abs(sum - 1.0f) > kSumTolerance) ++found_.unnormalised;
        if (std::abs(sum - 1.0f) > std::abs(found_.worstSum - 1.0f)) found_.worstSum = sum;
        for (std::size_t i = begin; i < out.influences.size(); ++i) out.influences[i].weight /= sum;
    }

    XmlNode element_;
    const LoadContext& context_;
    const Layout& layout_;
    std::size_t jointCount_;
    Findings found_;
};

void checkCount(XmlNode vertexWeights, std::size_t vcounts, Diagnostics& diagnostics) {
    std::uint64_t count = 0;
    if (!parseUnsigned(vertexWeights.attribute("count"), count))
        diagnostics.report(Code::MissingAttribute, vertexWeights, {"vertex_weights", "usable count"});
    else if (count != vcounts)
        diagnostics.report(Code::CountMismatch, vertexWeights,
                           {"vertex_weights", std::to_string(count), "positions", std::to_string(vcounts)});
}

// How many influences each position has, cut off where a count is negative or <v> ends.
std::vector<std::size_t> readVcounts(XmlNode vertexWeights, std::size_t groups, std::size_t positionCount,
                                     const LoadContext& context) {
    const XmlNode element = vertexWeights.child("vcount");
    const std::vector<std::int32_t> counts = readInts(element, context.diagnostics);
    checkCount(vertexWeights, counts.size(), context.diagnostics);
    std::vector<std::size_t> usable;
    std::size_t used = 0;
    for (const std::int32_t count : counts) {
        if (usable.size() == positionCount) break;
        const auto wanted = static_cast<std::size_t>(std::max(0, count));
        context.require(wanted, context.options.limits.maxInfluencesPerVertex, "influences of a vertex",
                        element);
        if (count < 0 || wanted > groups - used) {
            context.diagnostics.report(
                Code::CountMismatch, element ? element : vertexWeights,
                {"v", "at least " + std::to_string(used + wanted), "influences", std::to_string(groups)});
            return usable;
        }
        used += wanted;
        usable.push_back(wanted);
    }
    if (used != groups && usable.size() == counts.size())
        context.diagnostics.report(
            Code::CountMismatch, element ? element : vertexWeights,
            {"vcount", std::to_string(used), "influences", std::to_string(groups) + " in <v>"});
    return usable;
}

}  // namespace

Influences readWeights(XmlNode vertexWeights, std::size_t positionCount, std::size_t jointCount,
                       const LoadContext& context) {
    Influences out;
    out.first.push_back(0);
    Layout layout;
    const bool usable = readLayout(vertexWeights, context, layout);
    Reader reader(vertexWeights, context, layout, jointCount);
    if (usable) {
        const std::vector<std::int32_t> v = readInts(vertexWeights.child("v"), context.diagnostics);
        const std::vector<std::size_t> counts =
            readVcounts(vertexWeights, v.size() / layout.stride, positionCount, context);
        std::size_t at = 0;
        for (const std::size_t count : counts) {
            reader.add(v.data() + at, count, out);
            at += count * layout.stride;
        }
        reader.report();
        if (counts.size() < positionCount)
            context.diagnostics.report(Code::WeightsShorterThanMesh, vertexWeights,
                                       {std::to_string(counts.size()), std::to_string(positionCount)});
    }
    while (out.first.size() < positionCount + 1) reader.addUnweighted(out);
    return out;
}

}  // namespace walkcycle
