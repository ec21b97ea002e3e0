#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace slicefarm::milling {

/// Surface to mill, in mm. It need not be closed or consistently oriented.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> points_mm;  ///< corners of the triangles; all coordinates are finite
  std::vector<std::array<uint32_t, 3>> triangles;  ///< indices into `points_mm`, all valid
};

/// Edges of a mesh, each edge once. The two ends of an edge are sorted by their coordinates, so
/// that results do not depend on the order of triangles and corners.
struct MeshEdges {
  std::vector<std::array<uint32_t, 2>> ends;
  /// Indices of the three edges of each triangle: from corner 0 to 1, 1 to 2, 2 to 0; indexed by
  /// triangle.
  std::vector<std::array<uint32_t, 3>> of_triangle;
};

/// Returns the edges of a mesh. Cost: O(n log n) for n triangles.
MeshEdges EdgesOf(const TriangleMesh& mesh);

/// Returns true if `a` is before `b` in the order of their coordinates, which is independent of the
/// order in a file.
inline bool ByCoordinates(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

/// Direction of fibers: the horizontal lines along which the cutter is pushed.
enum class FiberAxis : uint8_t { kX, kY };

/// Returns the coordinate of `p` along fibers of this direction.
inline double AlongOf(const Eigen::Vector3d& p, FiberAxis axis) {
  return axis == FiberAxis::kX ? p.x() : p.y();
}
/// Returns the coordinate of `p` across fibers of this direction.
inline double AcrossOf(const Eigen::Vector3d& p, FiberAxis axis) {
  return axis == FiberAxis::kX ? p.y() : p.x();
}

}  // namespace slicefarm::milling
