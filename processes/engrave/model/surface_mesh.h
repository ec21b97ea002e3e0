#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace slicefarm {

/// A surface of triangles, in mm: doubles as the file has them. A point may be used by no triangle.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<std::array<int32_t, 3>> triangles;  ///< counter-clockwise as seen from outside

  friend bool operator==(const SurfaceMesh&, const SurfaceMesh&) = default;
};

}  // namespace slicefarm
