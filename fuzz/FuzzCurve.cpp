// Any numbers as the keys of a curve: as the loader hands them over, that is finite and with times that do not fall.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "Require.h"
#include "loaders/curves/CurveBuilder.h"

namespace {

using namespace walkcycle;

class Numbers {
public:
    Numbers(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    std::uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *data_++;
    }
    // As large as a float can be, since that is what files hold.
    double number() {
        float value = 0.0f;
        if (left_ >= sizeof value) std::memcpy(&value, data_, sizeof value);
        const std::size_t used = std::min(left_, sizeof value);
        data_ += used;
        left_ -= used;
        return std::isfinite(value) ? static_cast<double>(value) : 0.0;
    }
    std::vector<double> numbers(std::size_t count) {
        std::vector<double> list(count);
        for (double& value : list) value = number();
        return list;
    }

private:
    const std::uint8_t* data_;
    std::size_t left_;
};

CurveKeys keysFrom(Numbers& numbers) {
    CurveKeys keys;
    const std::size_t count = 1 + numbers.byte() % 8;
    keys.width = 1 + numbers.byte() % 4;
    const std::size_t widths[] = {2 * keys.width, keys.width, keys.width + 1};
    keys.tangentWidth = widths[numbers.byte() % 3];
    for (std::size_t i = 0; i < count; ++i)
        keys.interpolations.push_back(static_cast<Interpolation>(numbers.byte() % 6));
    keys.times = numbers.numbers(count);
    std::sort(keys.times.begin(), keys.times.end());
    keys.values = numbers.numbers(count * keys.width);
    keys.inTangents = numbers.numbers(count * keys.tangentWidth);
    keys.outTangents = numbers.numbers(count * keys.tangentWidth);
    return keys;
}

void checkAt(const Curve& curve, double seconds) {
    std::vector<double> value(curve.width);
    for (const Side side : {Side::Left, Side::Right}) {
        curve.evaluate(seconds, side, value);
        for (const double number : value) REQUIRE(!std::isnan(number));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Numbers numbers(data, size);
    const Infinity before = static_cast<Infinity>(numbers.byte() % 5);
    const Infinity after = static_cast<Infinity>(numbers.byte() % 5);
    const double elsewhere = numbers.number();
    Curve curve = makeCurve(keysFrom(numbers));
    curve.before = before;
    curve.after = after;
    const double start = curve.start(), end = curve.end(), length = end - start;
    for (const double seconds :
         {start, end, start + 0.3 * length, start - length, end + 2.6 * length, elsewhere})
        checkAt(curve, seconds);
    std::vector<double> knots;
    curve.knots(std::min(start, elsewhere), std::max(end, elsewhere), 1000, knots);
    REQUIRE(knots.size() <= 1000);
    std::size_t place = 0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        if (knots[i + 1] <= knots[i]) continue;
        checkAt(curve, 0.5 * (knots[i] + knots[i + 1]));
        curve.holds(knots[i], knots[i + 1]);
        for (std::size_t k = 0; k < curve.width; ++k)
            REQUIRE(!(curve.travel(knots[i], knots[i + 1], k, place) < 0.0));
    }
    return 0;
}
