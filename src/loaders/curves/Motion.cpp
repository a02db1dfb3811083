#include "loaders/curves/Motion.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace walkcycle {

namespace {

template <typename Binding>
std::vector<double> knotsOf(const std::vector<Binding>& bindings, double from, double to, std::size_t limit) {
    std::vector<double> all{from};
    for (const Binding& binding : bindings)
        binding.curve->knots(from, to, limit - std::min(limit, all.size() + 1), all);
    all.push_back(to);
    if (!std::is_sorted(all.begin(), all.end())) std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

template <typename Binding>
bool allHold(const std::vector<Binding>& bindings, double from, double to) {
    return std::all_of(bindings.begin(), bindings.end(),
                       [&](const Binding& b) { return b.curve->holds(from, to); });
}

template <typename Binding>
bool anyJumps(const std::vector<Binding>& bindings) {
    return std::any_of(bindings.begin(), bindings.end(),
                       [](const Binding& b) { return b.from > -1e300 || b.curve->mayJump(); });
}

bool goesStraight(const Curve& curve) {
    const auto isBezier = [](const Curve::Segment& segment) { return segment.kind == Curve::Kind::Bezier; };
    const auto rises = [](Infinity i) { return i == Infinity::Linear || i == Infinity::CycleRelative; };
    return !rises(curve.before) && !rises(curve.after) &&
           std::none_of(curve.segments.begin(), curve.segments.end(), isBezier);
}

bool overlapping(const CurveBinding& a, const CurveBinding& b) {
    return overlap(a, b);
}
bool overlapping(const ParameterMotion::Binding&, const ParameterMotion::Binding&) {
    return true;
}

// Sets `from` of bindings that move the same numbers: each takes over at its first key. Of bindings with the
// same first key, the last one in the file wins.
template <typename Binding>
void setTakeovers(std::vector<Binding>& bindings) {
    constexpr std::size_t kMost = 1000;  // no real file has so many; beyond, the order of the file stays
    for (Binding& binding : bindings) binding.from = -std::numeric_limits<double>::infinity();
    if (bindings.size() > kMost) return;
    std::stable_sort(bindings.begin(), bindings.end(),
                     [](const Binding& a, const Binding& b) { return a.curve->start() < b.curve->start(); });
    for (std::size_t i = 1; i < bindings.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (overlapping(bindings[i], bindings[k]) &&
                bindings[i].curve->start() > bindings[k].curve->start())
                bindings[i].from = bindings[i].curve->start();
}

}  // namespace

bool overlap(const CurveBinding& a, const CurveBinding& b) {
    return a.element == b.element && a.first < b.first + b.count && b.first < a.first + a.count;
}

void JointMotion::orderRivals() {
    setTakeovers(bindings);
}
void ParameterMotion::orderRivals() {
    setTakeovers(bindings);
}

// Fast path: nearly all baked files move each joint by one curve of whole matrices.
std::optional<glm::dmat4> JointMotion::wholeMatrix(double seconds, Side side) const {
    if (stack.size() != 1 || bindings.size() != 1) return std::nullopt;
    const CurveBinding& b = bindings[0];
    if (b.count != 16 || b.scale != 1.0 || !isInForce(b, seconds, side)) return std::nullopt;
    std::optional<glm::dmat4> matrix = b.curve->blendedAt(seconds, side);
    if (matrix && outer != glm::dmat4(1.0)) *matrix = outer * *matrix;
    return matrix;
}

glm::dmat4 JointMotion::localTransform(double seconds, Side side) const {
    if (const std::optional<glm::dmat4> whole = wholeMatrix(seconds, side)) return *whole;
    glm::dmat4 product = outer;
    std::array<double, 16> moved;
    std::array<double, 16> numbers;
    std::size_t hint = 0;  // most joints have curves with the same key times
    for (std::size_t e = 0; e < stack.size(); ++e) {
        const double* values = stack[e].values.data();
        for (const CurveBinding& b : bindings) {
            if (b.element != e || !isInForce(b, seconds, side)) continue;
            if (values != moved.data()) moved = stack[e].values;
            values = moved.data();
            b.curve->evaluate(seconds, side, numbers, hint);
            for (std::size_t i = 0; i < b.count; ++i) moved[b.first + i] = b.scale * numbers[b.component + i];
        }
        product = product * matrixOf(stack[e].kind, values);
    }
    return product;
}

std::vector<double> JointMotion::knots(double from, double to, std::size_t limit) const {
    return knotsOf(bindings, from, to, limit);
}

bool JointMotion::holds(double from, double to) const {
    return allHold(bindings, from, to);
}

bool JointMotion::mayJump() const {
    return anyJumps(bindings);
}

bool JointMotion::isStraight() const {
    return stack.size() == 1 && outer == glm::dmat4(1.0) && bindings.size() == 1 && bindings[0].count == 16 &&
           goesStraight(*bindings[0].curve);
}

bool JointMotion::hasPlainStack() const {
    using Kind = TransformElement::Kind;
    bool scaled = false;
    for (const Element& element : stack) {
        const bool isScale = element.kind == Kind::Scale;
        if (!isScale && (scaled || (element.kind != Kind::Translate && element.kind != Kind::Rotate)))
            return false;
        scaled = isScale;
    }
    return outer == glm::dmat4(1.0);
}

bool JointMotion::rotatesEvenly() const {
    if (!hasPlainStack()) return false;
    const auto isPlain = [](const CurveBinding& b) {
        const bool isEndless = b.curve->before != Infinity::Constant || b.curve->after != Infinity::Constant;
        return b.from < -1e300 && b.curve->parts.empty() && !isEndless && goesStraight(*b.curve);
    };
    if (!std::all_of(bindings.begin(), bindings.end(), isPlain)) return false;
    bool isRotated = false;
    for (std::size_t e = 0; e < stack.size(); ++e) {
        const bool isRotate = stack[e].kind == TransformElement::Kind::Rotate;
        const bool isTranslate = stack[e].kind == TransformElement::Kind::Translate;
        std::size_t moves = 0;
        for (const CurveBinding& b : bindings) {
            if (b.element != e) continue;
            if (isRotate && (b.first != 3 || isRotated || moves > 0)) return false;
            ++moves;
        }
        const auto isZero = [](double number) { return number == 0.0; };
        const auto& values = stack[e].values;
        const bool isZeroAlways = moves == 0 && std::all_of(values.begin(), values.begin() + 3, isZero);
        if (isRotated && isTranslate && !isZeroAlways) return false;
        isRotated = isRotated || (isRotate && moves > 0);
    }
    return true;
}

bool JointMotion::isStraightByNumber() const {
    return stack.size() == 1 && stack[0].kind == TransformElement::Kind::Matrix &&
           std::all_of(bindings.begin(), bindings.end(), [](const CurveBinding& b) {
               return b.count == 1 && b.curve->parts.empty() && goesStraight(*b.curve);
           });
}

std::vector<double> JointMotion::degreesRotated(const std::vector<double>& knots) const {
    std::vector<double> degrees;
    for (const CurveBinding& b : bindings) {
        if (stack[b.element].kind != TransformElement::Kind::Rotate || b.first + b.count != 4) continue;
        degrees.resize(knots.size() - 1);
        std::size_t hint = 0;
        for (std::size_t i = 1; i < knots.size(); ++i)
            degrees[i - 1] += b.curve->travel(knots[i - 1], knots[i], b.component + b.count - 1, hint);
    }
    return degrees;
}

double ParameterMotion::value(double seconds, Side side) const {
    double result = restValue;
    std::vector<double> numbers;
    for (const Binding& b : bindings) {
        if (!isInForce(b, seconds, side)) continue;
        numbers.resize(b.curve->width);
        b.curve->evaluate(seconds, side, numbers);
        result = numbers[b.component];
    }
    return result;
}

std::vector<double> ParameterMotion::knots(double from, double to, std::size_t limit) const {
    return knotsOf(bindings, from, to, limit);
}

bool ParameterMotion::holds(double from, double to) const {
    return allHold(bindings, from, to);
}

bool ParameterMotion::mayJump() const {
    return anyJumps(bindings);
}

Motion::Motion(std::vector<Curve> curves, const SceneGraph& scene)
    : curves_(std::make_shared<const std::vector<Curve>>(std::move(curves))) {
    for (std::size_t i = 0; i < scene.stacks.size(); ++i)
        restTransforms_.push_back(scene.outer[i] * scene.stacks[i].toMatrix());
}

Motion Motion::restricted(const std::function<bool(int)>& plays) const {
    Motion part = *this;
    const auto keep = [&](auto& motions) {
        for (auto& motion : motions) {
            std::erase_if(motion.bindings, [&](const auto& binding) { return !plays(binding.channel); });
            motion.orderRivals();
        }
        std::erase_if(motions, [](const auto& motion) { return motion.bindings.empty(); });
    };
    keep(part.joints);
    keep(part.parameters);
    return part;
}

double Motion::start() const {
    double earliest = std::numeric_limits<double>::infinity();
    for (const JointMotion& motion : joints)
        for (const CurveBinding& b : motion.bindings) earliest = std::min(earliest, b.curve->start());
    for (const ParameterMotion& motion : parameters)
        for (const auto& b : motion.bindings) earliest = std::min(earliest, b.curve->start());
    return earliest;
}

double Motion::end() const {
    double latest = -std::numeric_limits<double>::infinity();
    for (const JointMotion& motion : joints)
        for (const CurveBinding& b : motion.bindings) latest = std::max(latest, b.curve->end());
    for (const ParameterMotion& motion : parameters)
        for (const auto& b : motion.bindings) latest = std::max(latest, b.curve->end());
    return latest;
}

void Motion::evaluate(double seconds, std::span<glm::dmat4> localTransforms, std::span<double> values) const {
    std::copy_n(restTransforms_.begin(), std::min(restTransforms_.size(), localTransforms.size()),
                localTransforms.begin());
    std::copy_n(restParameters.begin(), std::min(restParameters.size(), values.size()), values.begin());
    for (const JointMotion& motion : joints)
        if (static_cast<std::size_t>(motion.joint) < localTransforms.size())
            localTransforms[static_cast<std::size_t>(motion.joint)] = motion.localTransform(seconds);
    for (const ParameterMotion& motion : parameters)
        if (static_cast<std::size_t>(motion.parameter) < values.size())
            values[static_cast<std::size_t>(motion.parameter)] = motion.value(seconds);
}

}  // namespace walkcycle
