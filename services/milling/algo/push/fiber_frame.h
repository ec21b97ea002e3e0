#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "common/model/options/cutter.h"
#include "common/model/setting.h"
#include "services/milling/algo/mesh/triangle_mesh.h"
#include "services/milling/algo/push/edge_push.h"
#include "services/milling/algo/push/facet_push.h"
#include "services/milling/algo/push/intervals.h"

namespace slicefarm::milling {

/// Fiber: a horizontal line along which the cutter is pushed.
struct Fiber {
  double across_mm = 0;
  double z_mm = 0;  ///< height of the cutter's tip
};

/// Height tolerance in mm: parts up to this much above the tip's height count as level with the
/// tip. Touching is not a hit. So a level face at the tip's height does not block the cutter,
/// regardless of the rounding of its corners.
inline constexpr double kTouchMm = 1e-9;

/// View of a mesh along the fibers of one axis. The mesh and its edges must outlive this object.
class FiberFrame {
 public:
  FiberFrame(const TriangleMesh& mesh, const MeshEdges& edges, FiberAxis axis);

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshEdges& edges() const { return edges_; }
  FiberAxis axis() const { return axis_; }

  /// Returns a point of the mesh relative to a fiber.
  FiberPoint At(uint32_t point, const Fiber& fiber) const {
    const FiberPoint& p = points_[point];
    return {p.along, p.across - fiber.across_mm, p.height - fiber.z_mm};
  }

  /// Returns the part of a fiber in which the cutter gouges an edge.
  Reach PushSide(const Cutter& cutter, uint32_t edge, const Fiber& fiber) const {
    const auto& ends = edges_.ends[edge];
    return PushEdge(cutter, At(ends[0], fiber), At(ends[1], fiber));
  }

  /// Returns the interval in which the cutter gouges a triangle, computed from the results of
  /// PushSide for its three sides and from its inside. The interval is empty if low >= high. There
  /// is only one interval, because the cutter and the triangle are convex.
  Interval Hull(const Cutter& cutter, uint32_t triangle, const Fiber& fiber,
                const std::array<Reach, 3>& sides) const;
  /// Returns the interval in which the cutter gouges a triangle. It is empty if low >= high.
  Interval PushTriangle(const Cutter& cutter, uint32_t triangle, const Fiber& fiber) const;

  /// Returns the point of the mesh that the cutter touches at an end of an interval, in x, y, z.
  Eigen::Vector3d ContactOf(const Cutter& cutter, const Source& source, const Fiber& fiber,
                            bool high) const;

 private:
  std::array<FiberPoint, 3> CornersOf(uint32_t triangle, const Fiber& fiber) const;
  Eigen::Vector3d Unframed(const FiberPoint& p, const Fiber& fiber) const;

  const TriangleMesh& mesh_;
  const MeshEdges& edges_;
  FiberAxis axis_;
  /// Corners per triangle, sorted by their coordinates, so that results do not depend on the file's
  /// order.
  std::vector<std::array<uint32_t, 3>> corners_;
  /// points of the mesh in fiber coordinates; the height is the mesh's z, not relative to a tip
  std::vector<FiberPoint> points_;
  std::vector<FacetNormal> normals_;  ///< normals of the triangles
};

}  // namespace slicefarm::milling
