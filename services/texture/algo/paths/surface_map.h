#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "processes/engrave/model/engrave_settings.h"
#include "services/texture/algo/surface/cut_open.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Point on a surface: a triangle, and barycentric weights of its corners. On an edge, the weight
/// of the opposite corner is exactly 0.
struct SurfacePoint {
  int32_t triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
};

using slicefarm::NormalKind;

/// Surface with disk topology, possibly with holes, and its one-to-one map into the plane. If a
/// closed surface was cut open, it keeps the normals of the closed surface.
class SurfaceMap {
 public:
  /// `points_mm`: position in the map of each vertex of the opened mesh (Flatten).
  SurfaceMap(OpenedSurface opened, std::vector<Eigen::Vector2d> points_mm);

  const SurfaceMesh& mesh() const { return mesh_; }
  std::span<const Eigen::Vector2d> map_mm() const { return map_mm_; }
  std::span<const int32_t> vertex_of() const { return vertex_of_; }
  /// Returns the neighbour across the side of a triangle from corner k to the next corner; -1 if
  /// there is none.
  int32_t Neighbour(int32_t triangle, int k) const { return neighbours_[triangle][k]; }
  /// Returns the boundary loops of the map as vertices, the outer loop first, then the holes. The
  /// map is on their left.
  std::span<const std::vector<int32_t>> loops() const { return loops_; }
  /// Side of a triangle on the boundary. `corner`: index of the corner at which the side begins.
  struct BoundarySide {
    int32_t triangle = -1;
    int corner = 0;
  };
  /// Returns the boundary side that begins at a vertex.
  BoundarySide SideFrom(int32_t vertex) const { return side_from_[vertex]; }
  /// Position of a boundary vertex in its loop.
  struct LoopPosition {
    int32_t loop = -1;
    int32_t index = 0;
  };
  /// Returns the position of a vertex in its loop. `loop` is -1 if the vertex is not on the
  /// boundary.
  LoopPosition InLoop(int32_t vertex) const { return in_loop_[vertex]; }

  /// Returns a point's position in the map.
  Eigen::Vector2d MapPosition(const SurfacePoint& point) const;
  /// Returns a point's position in space.
  Eigen::Vector3d Position(const SurfacePoint& point) const;
  /// Returns the normal at a point.
  Eigen::Vector3d Normal(const SurfacePoint& point, NormalKind kind) const;
  /// Returns the normal of a triangle.
  const Eigen::Vector3d& FaceNormal(int32_t triangle) const { return face_normals_[triangle]; }
  /// Returns the normal at a vertex.
  const Eigen::Vector3d& VertexNormal(int32_t vertex) const { return vertex_normals_[vertex]; }

  Eigen::Vector2d low_mm() const { return low_mm_; }  ///< corner of the map's box
  Eigen::Vector2d high_mm() const { return high_mm_; }

  /// Returns the point of the surface closest to a position in space. Cost: O(n) for n triangles.
  SurfacePoint NearestTo(const Eigen::Vector3d& place_mm) const;

 private:
  SurfaceMesh mesh_;
  std::vector<int32_t> vertex_of_;
  std::vector<Eigen::Vector2d> map_mm_;
  std::vector<std::array<int32_t, 3>> neighbours_;
  std::vector<std::vector<int32_t>> loops_;
  std::vector<BoundarySide> side_from_;  ///< boundary side that begins at each vertex
  std::vector<LoopPosition> in_loop_;    ///< position of each vertex in its loop
  std::vector<Eigen::Vector3d> face_normals_;
  std::vector<Eigen::Vector3d> vertex_normals_;  ///< normals of the opened mesh's vertices
  /// normals of each triangle's three sides; side k begins at corner k
  std::vector<std::array<Eigen::Vector3d, 3>> edge_normals_;
  Eigen::Vector2d low_mm_;
  Eigen::Vector2d high_mm_;
};

}  // namespace slicefarm::texture
