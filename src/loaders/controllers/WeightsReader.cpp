#include "loaders/controllers/WeightsReader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "loaders/sources/Inputs.h"
#include "loaders/text/NumberParser.h"

namespace walkcycle {
namespace {

constexpr float kSumTolerance = 0.02f;  // exporters round to two or three digits

// The layout of <v>: an influence is a group of `stride` numbers, with a joint index and a weight index at
// these offsets.
struct Layout {
    std::size_t jointOffset = 0, weightOffset = 0, stride = 1;
    std::shared_ptr<const FloatSource> weights;
};

// Faults that are counted and reported once, with the place of the first or worst: an entry of the WEIGHT
// source, a number of <v>, a position.
struct Findings {
    std::size_t negative = 0, unnormalised = 0, unweighted = 0;
    std::size_t negativeEntry = 0, worstNumber = 0, unweightedPosition = 0;
    float worstSum = 1.0f;
    int outOfRange = 0;
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
            layout.weights = context.sources.floats(input.source, NumberFaults::Error);
            if (layout.weights && layout.weights->width != 1)
                context.diagnostics.report(Code::SourceWidth, input.element,
                                           {input.semantic, std::to_string(layout.weights->width), "1"});
        }
    }
    if (hasJoints && layout.weights) return true;
    context.diagnostics.report(
        Code::MissingElement, vertexWeights,
        {"vertex_weights", hasJoints ? "input semantic=\"WEIGHT\"" : "input semantic=\"JOINT\""});
    return false;
}

// Reads the influences position by position.
class InfluenceReader {
public:
    InfluenceReader(XmlNode element, const LoadContext& context, const Layout& layout, std::size_t jointCount)
        : element_(element),
          context_(context),
          layout_(layout),
          jointCount_(jointCount),
          weightCount_(layout.weights ? layout.weights->count() : 0),
          v_(readInts(element.child("v"), context.diagnostics, context.pieceRead())) {}

    std::size_t groupCount() const { return v_.size() / layout_.stride; }

    // Reads the influences of the next position, which has `count` of them.
    void add(std::size_t count, Influences& out) {
        const std::size_t begin = out.influences.size(), number = at_;
        for (std::size_t i = 0; i < count; ++i, at_ += layout_.stride) addOne(v_.data() + at_, out);
        normalise(out, begin, number);
        out.first.push_back(static_cast<std::uint32_t>(out.influences.size()));
    }

    void addUnweighted(Influences& out) {
        out.influences.push_back({static_cast<std::uint32_t>(jointCount_), 1.0f});
        out.first.push_back(static_cast<std::uint32_t>(out.influences.size()));
    }

    void report() const {
        Diagnostics& diagnostics = context_.diagnostics;
        const XmlNode v = element_.child("v"), vcount = element_.child("vcount");
        if (found_.negative)
            diagnostics.report(Code::NegativeWeight, layout_.weights->array,
                               {std::to_string(found_.negative)},
                               layout_.weights->lineOf(found_.negativeEntry));
        if (found_.unnormalised)
            diagnostics.report(Code::WeightsNotNormalised, v,
                               {std::to_string(found_.unnormalised), format(found_.worstSum)},
                               v.lineOfWord(found_.worstNumber));
        if (found_.unweighted)
            diagnostics.report(Code::UnweightedVertices, vcount, {std::to_string(found_.unweighted)},
                               vcount.lineOfWord(found_.unweightedPosition));
    }

private:
    void addOne(const std::int32_t* group, Influences& out) {
        const std::int32_t joint = group[layout_.jointOffset], weight = group[layout_.weightOffset];
        if (weight < 0 || static_cast<std::size_t>(weight) >= weightCount_) {
            outOfRange("weight", group + layout_.weightOffset, weightCount_);
            return;
        }
        if (joint < -1 || (joint >= 0 && static_cast<std::size_t>(joint) >= jointCount_)) {
            outOfRange("joint", group + layout_.jointOffset, jointCount_);
            return;
        }
        const float value = (*layout_.weights)[static_cast<std::size_t>(weight)][0];
        if (value < 0.0f && found_.negative++ == 0) found_.negativeEntry = static_cast<std::size_t>(weight);
        if (value > 0.0f)
            out.influences.push_back(
                {joint < 0 ? static_cast<std::uint32_t>(jointCount_) : static_cast<std::uint32_t>(joint),
                 value});
    }

    void outOfRange(const char* what, const std::int32_t* index, std::size_t count) {
        const XmlNode v = element_.child("v");
        const bool looked = ++found_.outOfRange <= kMostLinesLookedFor;
        context_.diagnostics.report(Code::InfluenceOutOfRange, v,
                                    {what, std::to_string(*index), std::to_string(count)},
                                    looked ? v.lineOfWord(static_cast<std::size_t>(index - v_.data())) : 0);
    }

    // Scales the weights of a position, from out.influences[begin] on, to the sum 1. `number` is the index in
    // <v> of its first number.
    void normalise(Influences& out, std::size_t begin, std::size_t number) {
        float sum = 0.0f;
        for (std::size_t i = begin; i < out.influences.size(); ++i) sum += out.influences[i].weight;
        if (out.influences.size() == begin || !(sum > 1e-12f) || !std::isfinite(sum)) {
            out.influences.resize(begin);
            out.influences.push_back({static_cast<std::uint32_t>(jointCount_), 1.0f});
            if (found_.unweighted++ == 0) found_.unweightedPosition = out.first.size() - 1;
            return;
        }
        if (std::abs(sum - 1.0f) > kSumTolerance) ++found_.unnormalised;
        if (std::abs(sum - 1.0f) > std::abs(found_.worstSum - 1.0f)) {
            found_.worstSum = sum;
            found_.worstNumber = number;
        }
        for (std::size_t i = begin; i < out.influences.size(); ++i) out.influences[i].weight /= sum;
    }

    XmlNode element_;
    const LoadContext& context_;
    const Layout& layout_;
    std::size_t jointCount_, weightCount_;
    std::vector<std::int32_t> v_;
    std::size_t at_ = 0;  // index into v_ of the next position
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

// The number of influences of each position. The list ends before a negative count, and where <v> has too few
// numbers; that is reported.
std::vector<std::size_t> readVcounts(XmlNode vertexWeights, std::size_t groups, std::size_t positionCount,
                                     const LoadContext& context) {
    const XmlNode element = vertexWeights.child("vcount");
    const std::vector<std::int32_t> counts = readInts(element, context.diagnostics, context.pieceRead());
    checkCount(vertexWeights, counts.size(), context.diagnostics);
    std::vector<std::size_t> usable;
    std::size_t used = 0;
    for (const std::int32_t count : counts) {
        if (usable.size() == positionCount) break;
        const auto wanted = static_cast<std::size_t>(std::max(0, count));
        if (wanted > context.options.limits.maxInfluencesPerVertex)
            context.require(wanted, &LoadLimits::maxInfluencesPerVertex, element);
        if (count < 0 || wanted > groups - used) {
            context.diagnostics.report(
                Code::CountMismatch, element,
                {"v", "at least " + std::to_string(used + wanted), "influences", std::to_string(groups)},
                element.lineOfWord(usable.size()));
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
    out.first.reserve(positionCount + 1);
    out.first.push_back(0);
    Layout layout;
    const bool usable = readLayout(vertexWeights, context, layout);
    InfluenceReader reader(vertexWeights, context, layout, jointCount);
    if (usable) {
        const std::vector<std::size_t> counts =
            readVcounts(vertexWeights, reader.groupCount(), positionCount, context);
        out.influences.reserve(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
        for (const std::size_t count : counts) reader.add(count, out);
        reader.report();
        if (counts.size() < positionCount)
            context.diagnostics.report(Code::WeightsShorterThanMesh, vertexWeights,
                                       {std::to_string(counts.size()), std::to_string(positionCount)});
    }
    while (out.first.size() < positionCount + 1) reader.addUnweighted(out);
    return out;
}

}  // namespace walkcycle
