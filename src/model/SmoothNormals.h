#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// The angle between two faces above which the edge between them stays hard. A limb of five sides (72 degrees
// between two) is smooth; a box (90 degrees) is not. The value is measured on meshes that have normals
// (docs/collada-notes.md): larger ones smooth boxes and belts, smaller ones leave facets visible.
inline constexpr float kCreaseAngleDegrees = 75.0f;

// Computes normals for a mesh, one per corner of `faces`: the mean of the normals of the faces that meet at
// the corner within the crease angle, each weighted by the angle of its polygon there. (Polygons, not
// triangles: how they are cut leaves no trace.) Positions with equal values count as one. A corner of which
// no face has an area gets +Y. `rest` decides which faces are smoothed together, `deformed` gives their
// directions. Pass the same vector twice, except for a morph target of a mesh with normals: its corners must
// be smoothed as in the base mesh.
std::vector<glm::vec3> smoothNormals(const MeshFaces& faces, const std::vector<glm::vec3>& rest,
                                     const std::vector<glm::vec3>& deformed);

// Groups the corners by position. Positions with equal values are one group.
CornerGroups groupCorners(const MeshFaces& faces, const std::vector<glm::vec3>& positions);

// Computes the same for a mesh that moves. groupCorners() is called once, and memory is kept between calls.
class SmoothNormals {
public:
    // What one corner adds to the normals of the corners of its group: `weighted`, if the angle between their
    // creaseNormals (the normals of their faces in the `rest` shape) is within the crease angle.
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

// The vector scaled to unit length; zero if it has no direction.
glm::vec3 unitOrZero(const glm::dvec3& vector);

}  // namespace walkcycle
