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

/// A place on a surface: shares of a triangle's corners that add up to 1. On an edge, the share of
/// the corner opposite of it is exactly 0.
struct SurfacePoint {
  int32_t triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
};

using slicefarm::NormalKind;

/// A surface of disk topology, with holes or without, and its one-to-one map into the plane.
///
/// Where a closed surface was cut open, its normals are those of the closed one.
class SurfaceMap {
 public:
  /// `points_mm`: the map, by the opened mesh's vertices (Flatten).
  SurfaceMap(OpenedSurface opened, std::vector<Eigen::Vector2d> points_mm);

  const SurfaceMesh& mesh() const { return mesh_; }
  std::span<const Eigen::Vector2d> map_mm() const { return map_mm_; }
  std::span<const int32_t> vertex_of() const { return vertex_of_; }
  /// The triangle across the side from corner k to the next one; -1: none.
  int32_t Neighbour(int32_t triangle, int k) const { return neighbours_[triangle][k]; }
  /// Vertices around the map and its holes, the map on the left; the outer one first.
  std::span<const std::vector<int32_t>> loops() const { return loops_; }
  /// The triangle whose side leaves a vertex of the boundary along it, and the side's corner.
  struct BoundarySide {
    int32_t triangle = -1;
    int corner = 0;
  };
  BoundarySide SideFrom(int32_t vertex) const { return side_from_[vertex]; }
  /// Where a vertex of the boundary stands in its loop.
  struct LoopPlace {
    int32_t loop = -1;
    int32_t index = 0;
  };
  LoopPlace InLoop(int32_t vertex) const { return in_loop_[vertex]; }

  Eigen::Vector2d MapPlace(const SurfacePoint& point) const;
  Eigen::Vector3d Place(const SurfacePoint& point) const;
  Eigen::Vector3d Normal(const SurfacePoint& point, NormalKind kind) const;
  const Eigen::Vector3d& FaceNormal(int32_t triangle) const { return face_normals_[triangle]; }
  const Eigen::Vector3d& VertexNormal(int32_t vertex) const { return vertex_normals_[vertex]; }

  Eigen::Vector2d low_mm() const { return low_mm_; }  ///< the map's box
  Eigen::Vector2d high_mm() const { return high_mm_; }

  /// The point of the surface next to a place in space. Cost: O(n).
  SurfacePoint NearestTo(const Eigen::Vector3d& place_mm) const;

 private:
  SurfaceMesh mesh_;
  std::vector<int32_t> vertex_of_;
  std::vector<Eigen::Vector2d> map_mm_;
  std::vector<std::array<int32_t, 3>> neighbours_;
  std::vector<std::vector<int32_t>> loops_;
  std::vector<BoundarySide> side_from_;  ///< by vertex
  std::vector<LoopPlace> in_loop_;       ///< by vertex
  std::vector<Eigen::Vector3d> face_normals_;
  std::vector<Eigen::Vector3d> vertex_normals_;               ///< by the opened mesh's vertices
  std::vector<std::array<Eigen::Vector3d, 3>> edge_normals_;  ///< of the side from corner k
  Eigen::Vector2d low_mm_;
  Eigen::Vector2d high_mm_;
};

}  // namespace slicefarm::texture
