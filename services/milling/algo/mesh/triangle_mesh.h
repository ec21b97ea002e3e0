#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace slicefarm::milling {

/// The surface to mill, in mm. Only the surface counts: it need not be closed, nor turned one way.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> points_mm;          ///< finite
  std::vector<std::array<uint32_t, 3>> triangles;  ///< valid indices
};

/// Each edge once. Its ends are in the order of their coordinates, so that what is computed from
/// them does not depend on the order of triangles and corners.
struct MeshEdges {
  std::vector<std::array<uint32_t, 2>> ends;
  std::vector<std::array<uint32_t, 3>> of_triangle;  ///< from corner 0 to 1, 1 to 2, 2 to 0
};

/// Cost: O(n log n) for n triangles.
MeshEdges EdgesOf(const TriangleMesh& mesh);

/// An order of points that does not depend on a file's.
inline bool ByCoordinates(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

/// The way of fibers, and what else depends on it.
enum class FiberAxis : uint8_t { kX, kY };

/// Coordinates along the fibers of an axis and across them.
inline double AlongOf(const Eigen::Vector3d& p, FiberAxis axis) {
  return axis == FiberAxis::kX ? p.x() : p.y();
}
inline double AcrossOf(const Eigen::Vector3d& p, FiberAxis axis) {
  return axis == FiberAxis::kX ? p.y() : p.x();
}

}  // namespace slicefarm::milling
