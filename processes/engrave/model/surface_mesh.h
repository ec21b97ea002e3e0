#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace slicefarm {

/// Surface of triangles, in mm, with the double-precision coordinates of the file. Some points may
/// belong to no triangle.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> points_mm;
  /// Point indices, counter-clockwise as seen from outside.
  std::vector<std::array<int32_t, 3>> triangles;

  friend bool operator==(const SurfaceMesh&, const SurfaceMesh&) = default;
};

}  // namespace slicefarm
