#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/curves/Curve.h"
#include "loaders/curves/CurveBuilder.h"

namespace walkcycle {

// Reads <sampler>s (COLLADA 1.4.1, chapter 5), each once, also in other documents.
class SamplerReader {
public:
    explicit SamplerReader(const LoadContext& context) : context_(context) {}

    // Returns an index into curves(); -1, and reported, if the sampler has no keys.
    int read(XmlNode sampler);

    std::vector<Curve>& curves() { return curves_; }

private:
    bool readKeys(XmlNode sampler, CurveKeys& keys);
    void readInfinity(XmlNode sampler, Curve& curve);
    void readInterpolations(XmlNode sampler, XmlNode source, CurveKeys& keys);
    void readTangents(XmlNode sampler, XmlNode inSource, XmlNode outSource, CurveKeys& keys);
    void fixTimes(XmlNode sampler, const DoubleSource& source, CurveKeys& keys);

    const LoadContext& context_;
    std::unordered_map<XmlNode, int> read_;
    std::vector<Curve> curves_;
    std::uint64_t keyNumbers_ = 0;  // read so far, for LoadLimits::maxKeyNumbers
};

}  // namespace walkcycle
