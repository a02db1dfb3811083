#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// Faces whose normals differ by more than this keep a hard edge between them: a limb of five sides (72
// degrees between two) is still smooth; a box (90 degrees) and the sides of a steep pyramid are not. Measured
// on meshes that do have normals (docs/collada-notes.md): wider limits blunt boxes and belts, narrower ones
// show facets.
inline constexpr float kCreaseAngleDegrees = 75.0f;

// Normals for a mesh that has none, one per corner of the file: the mean of the faces that meet there, each
// weighted by its angle (the polygon's, before it is cut into triangles, so that the cut leaves no trace).
// Positions of equal value count as one. Corners that no face with an area uses get +Y. `rest` decides which
// faces are smoothed together, `deformed` gives their directions. Both are the same vector, except for morph
// targets of a mesh with normals, whose corners must be smoothed as in the base mesh.
std::vector<glm::vec3> smoothNormals(const MeshFaces& faces, const std::vector<glm::vec3>& rest,
                                     const std::vector<glm::vec3>& deformed);

// The corners at each position; those of equal positions are one group.
CornerGroups groupCorners(const MeshFaces& faces, const std::vector<glm::vec3>& positions);

// The same for a mesh that moves: groups are found once by groupCorners(), and memory is kept between calls.
class SmoothNormals {
public:
    // What a corner adds to the normals of the corners that it meets (`weighted`), and the normal of its
    // face, which decides which of them those are (`creaseNormal`).
    struct Share {
        glm::vec3 creaseNormal{0.0f};
        glm::vec3 weighted{0.0f};
    };

    // The result is valid until the next call.
    const std::vector<glm::vec3>& make(const MeshFaces& faces, const CornerGroups& meetings,
                                       const std::vector<glm::vec3>& rest,
                                       const std::vector<glm::vec3>& deformed);

private:
    std::vector<Share> shares_;
    std::vector<glm::vec3> normals_;
};

// The vector at unit length; zero if it has no direction.
glm::vec3 unitOrZero(const glm::dvec3& vector);

}  // namespace walkcycle
