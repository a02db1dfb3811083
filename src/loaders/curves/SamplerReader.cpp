#include "loaders/curves/SamplerReader.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "loaders/quirks/Dialect.h"
#include "loaders/sources/Inputs.h"
#include "loaders/sources/Source.h"

namespace walkcycle {

namespace {

constexpr std::string_view kSemantics =
    "INPUT OUTPUT INTERPOLATION IN_TANGENT OUT_TANGENT LINEAR_STEPS CONTINUITY";

std::optional<Interpolation> interpolationNamed(std::string_view name) {
    static constexpr std::pair<std::string_view, Interpolation> kNames[] = {
        {"LINEAR", Interpolation::Linear},     {"STEP", Interpolation::Step},
        {"BEZIER", Interpolation::Bezier},     {"HERMITE", Interpolation::Hermite},
        {"CARDINAL", Interpolation::Cardinal}, {"BSPLINE", Interpolation::BSpline}};
    for (const auto& [known, interpolation] : kNames)
        if (name == known) return interpolation;
    return std::nullopt;
}

// The words are those of pre_behavior in COLLADA 1.5, and of the quirk extra-infinity.
Infinity infinityNamed(std::string_view name) {
    if (name == "LINEAR" || name == "GRADIENT") return Infinity::Linear;
    if (name == "CYCLE") return Infinity::Cycle;
    if (name == "CYCLE_RELATIVE") return Infinity::CycleRelative;
    if (name == "OSCILLATE") return Infinity::Oscillate;
    return Infinity::Constant;
}

// The behaviour before or after the keys: an attribute of the sampler in COLLADA 1.5. With the quirk
// extra-infinity also an element in a <technique> of the INPUT source, or in an <extra> of that source or the
// sampler.
Infinity infinityOf(XmlNode sampler, XmlNode input, const char* element, const char* attribute,
                    Dialects& dialects) {
    if (sampler.has(attribute)) return infinityNamed(sampler.attribute(attribute));
    if (!dialects.follows(Quirk::ExtraInfinity, sampler)) return Infinity::Constant;
    for (XmlNode holder : {input, input.child("extra"), sampler.child("extra")})
        for (XmlNode technique : holder.children("technique"))
            if (XmlNode found = technique.child(element)) {
                const Infinity infinity = infinityNamed(found.text());
                if (infinity != Infinity::Constant) dialects.note(Quirk::ExtraInfinity, found);
                return infinity;
            }
    return Infinity::Constant;
}

XmlNode ownSource(XmlNode input) {
    std::string_view id = input.attribute("source");
    if (id.starts_with('#')) id.remove_prefix(1);
    const XmlNode source = input.elementById(id);
    return source.is("source") ? source : XmlNode();
}

// Channels find a sampler by its id, so it has one.
std::string samplerName(XmlNode sampler) {
    return std::string(sampler.id());
}

bool needsTangents(Interpolation i) {
    return i == Interpolation::Bezier || i == Interpolation::Hermite;
}

// The numbers per key: the width of the source, or more if the quirk forgotten-stride applies.
std::size_t widthOf(const DoubleSource& source, std::size_t keyCount, const LoadContext& context) {
    assert(keyCount > 0);
    const std::size_t perKey = source.values.size() / keyCount;
    const bool isForgotten = source.width == 1 && source.values.size() % keyCount == 0 &&
                             (perKey == 3 || perKey == 4 || perKey == 16);
    if (!isForgotten || !context.dialects.follows(Quirk::ForgottenStride, source.element))
        return source.width;
    context.diagnostics.report(Severity::Info, Code::SourceWidth, source.element,
                               {"OUTPUT", std::to_string(source.width), std::to_string(perKey)});
    context.dialects.note(Quirk::ForgottenStride, source.element);
    return perKey;
}

// Reports times with more than one number per entry. The first one counts.
void checkTimes(const DoubleSource& times, Diagnostics& diagnostics) {
    if (times.width != 1)
        diagnostics.report(Code::SourceWidth, times.element, {"INPUT", std::to_string(times.width), "1"});
}

// Keeps only the keys in `order`, in that order.
void reorder(CurveKeys& keys, const std::vector<std::size_t>& order) {
    const auto pick = [&](std::vector<double>& list, std::size_t width) {
        if (list.empty()) return;
        std::vector<double> picked;
        picked.reserve(order.size() * width);
        for (std::size_t i : order)
            for (std::size_t c = 0; c < width; ++c) picked.push_back(list[i * width + c]);
        list = std::move(picked);
    };
    std::vector<Interpolation> interpolations;
    for (std::size_t i : order) interpolations.push_back(keys.interpolations[i]);
    keys.interpolations = std::move(interpolations);
    pick(keys.times, 1);
    pick(keys.values, keys.width);
    pick(keys.inTangents, keys.tangentWidth);
    pick(keys.outTangents, keys.tangentWidth);
}

}  // namespace

int SamplerReader::read(XmlNode sampler) {
    if (const auto known = read_.find(sampler); known != read_.end()) return known->second;
    CurveKeys keys;
    int index = -1;
    if (readKeys(sampler, keys)) {
        index = static_cast<int>(curves_.size());
        curves_.push_back(makeCurve(std::move(keys)));
        readInfinity(sampler, curves_.back());
    }
    read_.emplace(sampler, index);
    return index;
}

void SamplerReader::readInfinity(XmlNode sampler, Curve& curve) {
    for (XmlNode input : sampler.children("input")) {
        if (input.attribute("semantic") != "INPUT") continue;
        const XmlNode source = context_.documents.resolve(input, input.attribute("source"));
        curve.before = infinityOf(sampler, source, "pre_infinity", "pre_behavior", context_.dialects);
        curve.after = infinityOf(sampler, source, "post_infinity", "post_behavior", context_.dialects);
    }
}

bool SamplerReader::readKeys(XmlNode sampler, CurveKeys& keys) {
    XmlNode input, output, interpolation, inTangent, outTangent;
    bool named[2] = {false, false};
    for (XmlNode i : sampler.children("input")) {
        const std::string_view semantic = i.attribute("semantic");
        if (semantic == "INPUT") input = context_.documents.follow(i, "source", "source"), named[0] = true;
        if (semantic == "OUTPUT") output = context_.documents.follow(i, "source", "source"), named[1] = true;
        // The others have defaults, so an unresolved reference is no error here.
        if (semantic == "INTERPOLATION") interpolation = ownSource(i);
        if (semantic == "IN_TANGENT") inTangent = ownSource(i);
        if (semantic == "OUT_TANGENT") outTangent = ownSource(i);
        checkSemantic(i, kSemantics, context_.diagnostics);
    }
    for (int i = 0; i < 2; ++i)
        if (!named[i])
            context_.diagnostics.report(Code::SamplerIncomplete, sampler,
                                        {samplerName(sampler), i ? "OUTPUT" : "INPUT"});
    if (!input || !output) return false;
    const auto times = context_.sources.doubles(input, NumberFaults::Error);
    const auto values = context_.sources.doublesToTake(output, NumberFaults::Error);
    if (!times || !values || times->count() == 0 || values->count() == 0) {
        context_.diagnostics.report(Code::SamplerIncomplete, sampler,
                                    {samplerName(sampler), times && times->count() ? "OUTPUT" : "INPUT"});
        return false;
    }
    checkTimes(*times, context_.diagnostics);
    keys.width = widthOf(*values, times->count(), context_);
    const std::size_t valueCount = values->values.size() / keys.width;
    if (times->count() != valueCount)
        context_.diagnostics.report(
            Code::SamplerKeyMismatch, sampler,
            {samplerName(sampler), std::to_string(times->count()), std::to_string(valueCount)});
    const std::size_t count = std::min(times->count(), valueCount);
    keyNumbers_ += count * (keys.width + 1);
    context_.require(keyNumbers_, &LoadLimits::maxKeyNumbers, sampler);
    keys.times.reserve(count);
    for (std::size_t i = 0; i < count; ++i) keys.times.push_back((*times)[i][0]);
    keys.values = std::move(values->values);
    keys.values.resize(count * keys.width);
    readInterpolations(sampler, interpolation, keys);
    readTangents(sampler, inTangent, outTangent, keys);
    fixTimes(sampler, *times, keys);
    return true;
}

void SamplerReader::readInterpolations(XmlNode sampler, XmlNode source, CurveKeys& keys) {
    keys.interpolations.assign(keys.times.size(), Interpolation::Linear);
    bool isIdref = false;
    const auto names = source ? context_.sources.names(source, isIdref, Severity::Warning) : nullptr;
    if (!names || names->count() == 0) {
        context_.diagnostics.report(Code::InterpolationMissing, sampler, {samplerName(sampler)});
        return;
    }
    std::optional<std::size_t> unknown;
    for (std::size_t i = 0; i < std::min(names->count(), keys.times.size()); ++i) {
        if (const auto interpolation = interpolationNamed((*names)[i][0]))
            keys.interpolations[i] = *interpolation;
        else if (!unknown)
            unknown = i;
    }
    if (unknown)
        context_.diagnostics.report(Code::InterpolationUnknown, names->array,
                                    {(*names)[*unknown][0], samplerName(sampler)}, names->lineOf(*unknown));
    // Each key but the last starts a segment.
    if (names->count() + 1 < keys.times.size())
        context_.diagnostics.report(Code::InterpolationMissing, sampler, {samplerName(sampler)});
}

void SamplerReader::readTangents(XmlNode sampler, XmlNode inSource, XmlNode outSource, CurveKeys& keys) {
    auto& kinds = keys.interpolations;
    if (std::none_of(kinds.begin(), kinds.end(), needsTangents) || kinds.size() < 2) return;
    const auto in = inSource ? context_.sources.doubles(inSource, NumberFaults::Warning) : nullptr;
    const auto out = outSource ? context_.sources.doubles(outSource, NumberFaults::Warning) : nullptr;
    const std::size_t count = keys.times.size();
    const std::size_t perKey = in ? in->values.size() / count : 0;
    const bool isSingle = perKey == keys.width;
    const bool fits = isSingle ? context_.dialects.follows(Quirk::SingleNumberTangents, sampler)
                               : tangentsFit(perKey, keys.width);
    if (in && out && fits && in->values.size() == perKey * count && out->values.size() == in->values.size()) {
        if (isSingle) context_.dialects.note(Quirk::SingleNumberTangents, inSource);
        keys.tangentWidth = perKey;
        keys.inTangents = in->values;
        keys.outTangents = out->values;
        return;
    }
    context_.diagnostics.report(Code::TangentsMissing, sampler, {samplerName(sampler)});
    std::replace_if(kinds.begin(), kinds.end(), needsTangents, Interpolation::Linear);
}

// Times must rise, except that two neighbouring keys at one time are a jump. Otherwise, the keys are sorted.
// Of keys with the same time that were not neighbours in the file, the first one counts; of more than two,
// the first and the last.
void SamplerReader::fixTimes(XmlNode sampler, const DoubleSource& source, CurveKeys& keys) {
    const std::size_t count = keys.times.size();
    bool sorted = true, tripled = false;
    std::size_t firstOdd = 0;
    for (std::size_t i = 1; i < count; ++i) {
        sorted = sorted && keys.times[i - 1] <= keys.times[i];
        tripled = tripled || (i > 1 && keys.times[i - 2] == keys.times[i]);
        if (firstOdd == 0 && (!sorted || tripled)) firstOdd = i;
    }
    const bool allSame = count > 1 && sorted && keys.times.front() == keys.times.back();
    if (sorted && !tripled && !allSame) return;
    context_.diagnostics.report(Code::KeyTimesInvalid, source.array,
                                {samplerName(sampler), allSame   ? "are all the same"
                                                       : !sorted ? "do not rise"
                                                                 : "name one time more than twice"},
                                source.lineOf(firstOdd));
    std::vector<std::size_t> order(count), kept;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keys.times[a] < keys.times[b]; });
    for (std::size_t i : order) {
        const bool same = !kept.empty() && keys.times[kept.back()] == keys.times[i];
        if (same && !sorted && kept.back() + 1 != i) continue;
        if (same && kept.size() > 1 && keys.times[kept[kept.size() - 2]] == keys.times[i])
            kept.back() = i;
        else
            kept.push_back(i);
    }
    reorder(keys, kept);
}

}  // namespace walkcycle
