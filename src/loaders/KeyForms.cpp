#include "loaders/KeyForms.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace walkcycle {

namespace {

CurvedTransform::Numbers numbersOf(const Placement& p) {
    const glm::dvec3& s = p.scale;
    const glm::dquat& q = p.rotation;
    return {p.position.x, p.position.y, p.position.z, q.x, q.y, q.z, q.w, s.x, s.y, s.z};
}

Placement nearTo(const Placement& other, Placement placement) {
    if (glm::dot(other.rotation, placement.rotation) < 0.0) placement.rotation = -placement.rotation;
    return placement;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

Placement StraightTransform::at(double progression) const {
    return {glm::mix(a.position, b.position, progression), turn.at(progression),
            glm::mix(a.scale, b.scale, progression)};
}

CurvedTransform CurvedTransform::throughFour(const Placement& a, const Placement& third,
                                             const Placement& twoThirds, const Placement& b) {
    const Placement c = nearTo(a, third), d = nearTo(c, twoThirds);
    CurvedTransform piece{a, nearTo(d, b)};
    const Numbers f0 = numbersOf(a), f1 = numbersOf(c), f2 = numbersOf(d), f3 = numbersOf(piece.b);
    for (std::size_t i = 0; i < f0.size(); ++i) {  // of the one cubic through four evenly spaced values
        piece.leaving[i] = -5.5 * f0[i] + 9.0 * f1[i] - 4.5 * f2[i] + f3[i];
        piece.arriving[i] = -f0[i] + 4.5 * f1[i] - 9.0 * f2[i] + 5.5 * f3[i];
    }
    return piece;
}

Placement CurvedTransform::at(double s) const {
    const double s2 = s * s, s3 = s2 * s;
    const double fromA = 2.0 * s3 - 3.0 * s2 + 1.0, fromLeaving = s3 - 2.0 * s2 + s, fromArriving = s3 - s2;
    const Numbers start = numbersOf(a), stop = numbersOf(b);
    Numbers n;
    for (std::size_t i = 0; i < n.size(); ++i)
        n[i] = fromA * start[i] + (1.0 - fromA) * stop[i] + fromLeaving * leaving[i] +
               fromArriving * arriving[i];
    return {{n[0], n[1], n[2]}, glm::normalize(glm::dquat(n[6], n[3], n[4], n[5])), {n[7], n[8], n[9]}};
}

double CurvedNumber::at(double s) const {
    const double s2 = s * s, s3 = s2 * s;
    const double fromB = 3.0 * s2 - 2.0 * s3;
    return (1.0 - fromB) * a + fromB * b + (s3 - 2.0 * s2 + s) * leaving + (s3 - s2) * arriving;
}

double shear(const MatrixParts& exact, const Tolerance& tolerance) {
    double most = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (row != column) most = std::max(most, std::abs(exact.stretch[column][row]));
    return tolerance.unit * tolerance.reach * most;
}

double distance(const Placement& exact, const Placement& keyed, const Tolerance& tolerance) {
    const glm::dquat apart = exact.rotation - keyed.rotation, other = exact.rotation + keyed.rotation;
    const double turned = 2.0 * std::sqrt(std::min(glm::dot(apart, apart), glm::dot(other, other)));
    const double linear = turned * largest(exact.scale) + largest(exact.scale - keyed.scale);
    return tolerance.unit * (glm::length(exact.position - keyed.position) + tolerance.reach * linear);
}

double distance(const glm::dmat4& exact, const glm::dmat4& keyed, const Tolerance& tolerance) {
    const glm::dmat4 apart = exact - keyed;
    double squares = 0.0;
    for (int column = 0; column < 3; ++column)
        squares += glm::dot(glm::dvec3(apart[column]), glm::dvec3(apart[column]));
    return tolerance.unit * (glm::length(glm::dvec3(apart[3])) + tolerance.reach * std::sqrt(squares));
}

double distance(double exact, double keyed, const Tolerance& tolerance) {
    return tolerance.unit * std::abs(exact - keyed);
}

}  // namespace walkcycle
