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

/// A fiber: a horizontal line that the cutter is pushed along.
struct Fiber {
  double across_mm = 0;
  double z_mm = 0;  ///< of the cutter's tip
};

/// What lies this little above the tip's height is level with it: touching is not a hit, and a flat
/// at the tip's height leaves the cutter free, however its corners are rounded. In mm.
inline constexpr double kTouchMm = 1e-9;

/// A mesh seen along the fibers of one axis. The mesh and its edges must outlive it.
class FiberFrame {
 public:
  FiberFrame(const TriangleMesh& mesh, const MeshEdges& edges, FiberAxis axis);

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshEdges& edges() const { return edges_; }
  FiberAxis axis() const { return axis_; }

  FiberPoint At(uint32_t point, const Fiber& fiber) const {
    const FiberPoint& p = points_[point];
    return {p.along, p.across - fiber.across_mm, p.height - fiber.z_mm};
  }

  Reach PushSide(const Cutter& cutter, uint32_t edge, const Fiber& fiber) const {
    const auto& ends = edges_.ends[edge];
    return PushEdge(cutter, At(ends[0], fiber), At(ends[1], fiber));
  }

  /// The whole triangle's interval, given what its sides have. Low >= high: none. As the cutter and
  /// the triangle are convex it is one: from the lowest to the highest contact.
  Interval Hull(const Cutter& cutter, uint32_t triangle, const Fiber& fiber,
                const std::array<Reach, 3>& sides) const;
  Interval PushTriangle(const Cutter& cutter, uint32_t triangle, const Fiber& fiber) const;

  /// The point of the mesh that the cutter touches at an end of an interval, in x, y, z.
  Eigen::Vector3d ContactOf(const Cutter& cutter, const Source& source, const Fiber& fiber,
                            bool high) const;

 private:
  std::array<FiberPoint, 3> CornersOf(uint32_t triangle, const Fiber& fiber) const;
  Eigen::Vector3d Unframed(const FiberPoint& p, const Fiber& fiber) const;

  const TriangleMesh& mesh_;
  const MeshEdges& edges_;
  FiberAxis axis_;
  /// By triangle, in the order of their coordinates: results do not depend on the file's order.
  std::vector<std::array<uint32_t, 3>> corners_;
  std::vector<FiberPoint> points_;    ///< height: z
  std::vector<FacetNormal> normals_;  ///< by triangle
};

}  // namespace slicefarm::milling
