#include "loaders/curves/Curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/RowMajor.h"

namespace walkcycle {

namespace {

double cubic(double a, double b, double c, double d, double s) {
    const double r = 1.0 - s;
    return r * r * (r * a + 3.0 * s * b) + s * s * (3.0 * r * c + s * d);
}

double cubicSlope(double a, double b, double c, double d, double s) {
    const double r = 1.0 - s;
    return 3.0 * (r * r * (b - a) + 2.0 * r * s * (c - b) + s * s * (d - c));
}

}  // namespace

// Newton's method. If a step would leave the bracket, the bracket is halved instead. The time never falls
// along the curve, so there is one answer (or one flat stretch of them).
double bezierParameter(double a, double b, double c, double d, double seconds) {
    if (!(d > a)) return 0.0;
    double low = 0.0, high = 1.0, s = std::clamp((seconds - a) / (d - a), 0.0, 1.0);
    for (int i = 0; i < 64; ++i) {
        const double miss = cubic(a, b, c, d, s) - seconds;
        if (miss == 0.0) break;
        (miss > 0.0 ? high : low) = s;
        const double steepness = cubicSlope(a, b, c, d, s);
        double next = steepness > 0.0 ? s - miss / steepness : 0.5 * (low + high);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - s) < 1e-15) break;
        s = next;
    }
    return s;
}

Curve::KeyTime Curve::keyTimeOf(double seconds, Side side) const {
    const bool early = seconds < start();
    const bool late = seconds > end();
    const double length = end() - start();
    const Infinity infinity = early ? before : after;
    if (!(early || late)) return {seconds, side};
    if (infinity == Infinity::Constant || !(length > 0.0))
        return {early ? start() : end(), early ? Side::Left : Side::Right};
    if (infinity == Infinity::Linear)
        return {early ? start() : end(), early ? Side::Left : Side::Right, 0.0,
                seconds - (early ? start() : end())};

    double cycle = std::floor((seconds - start()) / length);
    double within = std::clamp(seconds - start() - cycle * length, 0.0, length);
    if (side == Side::Left && within == 0.0) within = length, cycle -= 1.0;
    if (infinity == Infinity::Oscillate && std::fmod(std::abs(cycle), 2.0) == 1.0)
        return {end() - within, side == Side::Left ? Side::Right : Side::Left};
    return {start() + within, side, infinity == Infinity::CycleRelative ? cycle : 0.0};
}

// The segment of a time between the first and the last key. Side::Right: the segment with key <= time < next
// key; Side::Left: the one with key < time <= next key.
std::size_t Curve::segmentAt(double seconds, Side side) const {
    const auto above = side == Side::Right ? std::upper_bound(times.begin(), times.end(), seconds)
                                           : std::lower_bound(times.begin(), times.end(), seconds);
    const auto key = std::max<std::ptrdiff_t>(above - times.begin() - 1, 0);
    return std::min(static_cast<std::size_t>(key), segments.size() - 1);
}

// Tries the segment `near` and the one after it first.
std::size_t Curve::segmentAt(double seconds, Side side, std::size_t near) const {
    for (std::size_t k = near; k < near + 2 && k < segments.size(); ++k) {
        const double from = times[k], to = times[k + 1];
        if (side == Side::Right ? from <= seconds && seconds < to : from < seconds && seconds <= to) return k;
    }
    return segmentAt(seconds, side);
}

double Curve::bezier(std::size_t segment, std::size_t component, double seconds) const {
    const glm::dvec2* handle = &handles[segments[segment].handles + 2 * component];
    const double s = bezierParameter(times[segment], handle[0].x, handle[1].x, times[segment + 1], seconds);
    return cubic(values[segment * width + component], handle[0].y, handle[1].y,
                 values[(segment + 1) * width + component], s);
}

void Curve::evaluateInside(double seconds, Side side, std::span<double> out, std::size_t& hint) const {
    if (segments.empty() || (side == Side::Right && seconds >= end())) {
        std::copy_n(values.end() - static_cast<std::ptrdiff_t>(width), width, out.begin());
        return;
    }
    const std::size_t k = hint = segmentAt(seconds, side, hint);
    const double length = times[k + 1] - times[k];
    const double progression =
        length > 0.0 ? (seconds - times[k]) / length : 0.0;  // length is 0 at a jump, seen from the left
    const double* a = &values[k * width];
    if (segments[k].kind == Kind::Step || progression <= 0.0) {
        std::copy_n(a, width, out.begin());
    } else if (progression >= 1.0) {
        std::copy_n(a + width, width, out.begin());
    } else if (segments[k].kind == Kind::Bezier) {
        for (std::size_t c = 0; c < width; ++c) out[c] = bezier(k, c, seconds);
    } else if (!parts.empty()) {
        const auto rows = rowsOf(blend(parts[k], parts[k + 1], progression).toMatrix());
        std::copy(rows.begin(), rows.end(), out.begin());
    } else {
        for (std::size_t c = 0; c < width; ++c) out[c] = a[c] + (a[c + width] - a[c]) * progression;
    }
}

std::optional<glm::dmat4> Curve::blendedAt(double seconds, Side side) const {
    if (parts.empty() || segments.empty() || !(seconds > start() && seconds < end())) return std::nullopt;
    const std::size_t k = segmentAt(seconds, side);
    if (segments[k].kind != Kind::Linear || !(times[k] < seconds && seconds < times[k + 1]))
        return std::nullopt;
    const double progression = (seconds - times[k]) / (times[k + 1] - times[k]);
    return blend(parts[k], parts[k + 1], progression).toMatrix();
}

void Curve::evaluate(double seconds, Side side, std::span<double> out) const {
    std::size_t hint = 0;
    evaluate(seconds, side, out, hint);
}

void Curve::evaluate(double seconds, Side side, std::span<double> out, std::size_t& hint) const {
    const KeyTime at = keyTimeOf(seconds, side);
    evaluateInside(at.seconds, at.side, out, hint);
    if (at.cycles != 0.0)
        for (std::size_t c = 0; c < width; ++c)
            out[c] += at.cycles * (values[values.size() - width + c] - values[c]);
    if (at.beyond != 0.0)
        for (std::size_t c = 0; c < width; ++c) out[c] += at.beyond * slope(at.beyond > 0.0, c);
}

// Value per second at the first or last key, along the handle if there is one.
double Curve::slope(bool atEnd, std::size_t component) const {
    assert(!segments.empty());  // a single key has no slope
    const std::size_t k = atEnd ? segments.size() - 1 : 0;
    glm::dvec2 a(times[k], values[k * width + component]),
        b(times[k + 1], values[(k + 1) * width + component]);
    if (segments[k].kind == Kind::Step) return 0.0;
    if (segments[k].kind == Kind::Bezier) {
        const glm::dvec2 handle = handles[segments[k].handles + 2 * component + (atEnd ? 1 : 0)];
        const double reach = atEnd ? b.x - handle.x : handle.x - a.x;
        if (reach > 1e-9 * (b.x - a.x)) (atEnd ? a : b) = handle;
    }
    return b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0.0;
}

bool Curve::mayJump() const {
    const auto goesOn = [](Infinity i) { return i == Infinity::Constant || i == Infinity::Linear; };
    const auto isStep = [](const Segment& segment) { return segment.kind == Kind::Step; };
    return !goesOn(before) || !goesOn(after) || std::any_of(segments.begin(), segments.end(), isStep) ||
           std::adjacent_find(times.begin(), times.end()) != times.end();
}

bool Curve::holds(double from, double to) const {
    std::size_t hint = 0;
    return holds(from, to, hint);
}

bool Curve::holds(double from, double to, std::size_t& hint) const {
    const double middle = 0.5 * (from + to);
    const Infinity infinity = middle < start() ? before : after;
    const bool outside = middle < start() || middle > end();
    if (segments.empty() || (outside && infinity == Infinity::Constant)) return true;
    if (outside && infinity == Infinity::Linear) return false;
    const std::size_t k = hint = segmentAt(keyTimeOf(middle, Side::Right).seconds, Side::Right, hint);
    if (segments[k].kind == Kind::Step) return true;
    const double* a = &values[k * width];
    if (!std::equal(a, a + width, a + width)) return false;
    if (segments[k].kind == Kind::Linear) return true;
    const glm::dvec2* handle = &handles[segments[k].handles];
    for (std::size_t i = 0; i < 2 * width; ++i)
        if (handle[i].y != a[i / 2]) return false;
    return true;
}

void Curve::knots(double from, double to, std::size_t limit, std::vector<double>& out) const {
    const std::size_t most = out.size() + limit;
    const double length = end() - start();
    const auto repeats = [](Infinity i) { return i != Infinity::Constant && i != Infinity::Linear; };
    double first = 0.0, last = 0.0;  // the cycles that overlap the range
    if (length > 0.0 && repeats(before)) first = std::min(0.0, std::floor((from - start()) / length));
    if (length > 0.0 && repeats(after)) last = std::max(0.0, std::ceil((to - end()) / length));
    // The cycles are counted in integers: far from zero, a double plus one is the same double. Each cycle but
    // the outermost has a knot in the range.
    for (std::size_t n = 0; n < limit + 2 && out.size() < most; ++n) {
        const double cycle = first + static_cast<double>(n);
        if (cycle > last) break;
        const Infinity infinity = cycle < 0.0 ? before : after;
        const bool reversed =
            cycle != 0.0 && infinity == Infinity::Oscillate && std::fmod(std::abs(cycle), 2.0) == 1.0;
        for (std::size_t i = 0; i < times.size() && out.size() < most; ++i) {
            const double within = reversed ? end() - times[times.size() - 1 - i] : times[i] - start();
            const double knot = cycle == 0.0 ? times[i] : start() + cycle * length + within;
            if (knot >= from && knot <= to) out.push_back(knot);
        }
    }
}

double Curve::travel(double from, double to, std::size_t component, std::size_t& hint) const {
    if (holds(from, to, hint)) return 0.0;
    const KeyTime at = keyTimeOf(0.5 * (from + to), Side::Right);
    if (at.beyond != 0.0) return std::abs(slope(at.beyond > 0.0, component)) * (to - from);
    const std::size_t k = segmentAt(at.seconds, Side::Right, hint);
    const double a = values[k * width + component], b = values[(k + 1) * width + component];
    double way = std::abs(b - a);
    if (segments[k].kind == Kind::Bezier) {
        const glm::dvec2* handle = &handles[segments[k].handles + 2 * component];
        way = std::abs(handle[0].y - a) + std::abs(handle[1].y - handle[0].y) + std::abs(b - handle[1].y);
    }
    return way;
}

}  // namespace walkcycle
