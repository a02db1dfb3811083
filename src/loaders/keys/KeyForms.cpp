#include "loaders/keys/KeyForms.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace walkcycle {

namespace {

ExactTransform nearTo(const ExactTransform& other, ExactTransform transform) {
    if (glm::dot(other.rotation, transform.rotation) < 0.0) transform.rotation = -transform.rotation;
    return transform;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

ExactTransform StraightTransform::at(double progression) const {
    return {glm::mix(a.position, b.position, progression), rotation.at(progression),
            glm::mix(a.scale, b.scale, progression)};
}

CurvedTransform CurvedTransform::throughFour(const ExactTransform& a, const ExactTransform& third,
                                             const ExactTransform& twoThirds, const ExactTransform& b) {
    const ExactTransform c = nearTo(a, third), d = nearTo(c, twoThirds);
    const ExactTransform e = nearTo(d, b);
    CurvedTransform piece{a, e, {}, {}};
    piece.leaving = {leavingTangent(a.position, c.position, d.position, e.position),
                     leavingTangent(a.rotation, c.rotation, d.rotation, e.rotation),
                     leavingTangent(a.scale, c.scale, d.scale, e.scale)};
    piece.arriving = {arrivingTangent(a.position, c.position, d.position, e.position),
                      arrivingTangent(a.rotation, c.rotation, d.rotation, e.rotation),
                      arrivingTangent(a.scale, c.scale, d.scale, e.scale)};
    return piece;
}

ExactTransform CurvedTransform::at(double progression) const {
    return curvedTransform(a, leaving, b, arriving, Hermite(progression));
}

double shear(const MatrixParts& exact, const Tolerance& tolerance) {
    double most = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (row != column) most = std::max(most, std::abs(exact.stretch[column][row]));
    return tolerance.unit * tolerance.reach * most;
}

double distance(const ExactTransform& exact, const ExactTransform& keyed, const Tolerance& tolerance) {
    const glm::dquat apart = exact.rotation - keyed.rotation, other = exact.rotation + keyed.rotation;
    const double rotated = 2.0 * std::sqrt(std::min(glm::dot(apart, apart), glm::dot(other, other)));
    const double linear = rotated * largest(exact.scale) + largest(exact.scale - keyed.scale);
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
