#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/MeshFaces.h"

namespace walkcycle {

// Faces that meet at a sharper angle than this keep an edge between them: a limb of five sides (72 degrees
// between two) is still round, a box (90) and the sides of a steep pyramid are not. Measured on meshes that do
// have normals (docs/collada-notes.md): wider limits blunt boxes and belts, narrower ones show facets.
inline constexpr float kCreaseAngleDegrees = 75.0f;

// Normals for a mesh that has none, one per corner of the file: the mean of the faces that meet there, each weighted
// by its angle (the polygon's, before it is cut into triangles, so that the cut leaves no trace). Positions of equal
// value count as one. Corners that no face with an area uses get +Y.
//
// `rest` decides which faces smooth into each other, `deformed` where they point: the same vector, but for the targets of
// a morph of a mesh with normals, whose vertices must stay joined as they are at rest.
std::vector<glm::vec3> smoothNormals(const MeshFaces& faces, const std::vector<glm::vec3>& rest,
                                     const std::vector<glm::vec3>& deformed);

// The corners at each position; those of equal positions are one group.
CornerGroups groupCorners(const MeshFaces& faces, const std::vector<glm::vec3>& positions);

// The same for a mesh that moves, time and again: what meets is found once, and memory is kept between calls.
class SmoothNormals {
public:
    // What a corner adds to the normals around it, and the unit normal of its face that decides with which it blends.
    struct Share {
        glm::vec3 creaseNormal{0.0f};
        glm::vec3 weighted{0.0f};
    };

    // The result stands until the next call.
    const std::vector<glm::vec3>& make(const MeshFaces& faces, const CornerGroups& meetings,
                                       const std::vector<glm::vec3>& rest,
                                       const std::vector<glm::vec3>& deformed);

private:
    std::vector<Share> shares_;
    std::vector<glm::vec3> normals_;
};

// The direction of a vector as a unit vector; zero where it has none.
glm::vec3 unitOrZero(const glm::dvec3& vector);

}  // namespace walkcycle
