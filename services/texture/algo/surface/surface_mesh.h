#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "processes/engrave/model/surface_mesh.h"

namespace slicefarm::texture {

using slicefarm::SurfaceMesh;

/// Returns the normal of a triangle. The length of the normal is twice the triangle's area.
inline Eigen::Vector3d DoubleAreaVector(const SurfaceMesh& mesh, size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Eigen::Vector3d& origin = mesh.points_mm[a];
  return (mesh.points_mm[b] - origin).cross(mesh.points_mm[c] - origin);
}

}  // namespace slicefarm::texture
