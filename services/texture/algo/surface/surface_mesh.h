#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace slicefarm::texture {

/// A surface of triangles, in mm. A point may be used by no triangle.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<std::array<int32_t, 3>> triangles;  ///< counter-clockwise as seen from outside
};

/// Twice the area, along the normal.
inline Eigen::Vector3d DoubleAreaVector(const SurfaceMesh& mesh, size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Eigen::Vector3d& origin = mesh.points_mm[a];
  return (mesh.points_mm[b] - origin).cross(mesh.points_mm[c] - origin);
}

}  // namespace slicefarm::texture
