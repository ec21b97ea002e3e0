#pragma once

#include <cstdlib>
#include <numeric>
#include <utility>

#include "services/texture/algo/map/flatten.h"
#include "services/texture/algo/paths/surface_map.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"
#include "services/texture/algo/surface/seam.h"

namespace slicefarm::texture {

/// Returns the map of a mesh, which is cut open if necessary.
inline SurfaceMap FlatMapOf(const SurfaceMesh& mesh) {
  const auto topology = TopologyOf(mesh);
  if (!topology.ok()) std::abort();
  OpenedSurface opened = CutOpen(mesh, SeamOf(mesh, *topology));
  auto flat = Flatten(opened.mesh);
  if (!flat.ok()) std::abort();
  return {std::move(opened), std::move(flat->points_mm)};
}

/// Returns a map with x and y of each vertex, for a surface that is a function over the plane.
inline SurfaceMap MapFromAbove(const SurfaceMesh& mesh) {
  OpenedSurface opened{mesh, std::vector<int32_t>(mesh.points_mm.size())};
  std::iota(opened.vertex_of.begin(), opened.vertex_of.end(), 0);
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& p : mesh.points_mm) points.push_back(p.head<2>());
  return {std::move(opened), std::move(points)};
}

/// Returns a square with a square hole in its middle, from 0 to side.
inline SurfaceMesh SquareWithHole(int n, double side_mm) {
  return Without(FlatSquare(n, side_mm), [=](const Eigen::Vector3d& p) {
    return (p.head<2>() / side_mm - Eigen::Vector2d(0.5, 0.5)).cwiseAbs().maxCoeff() < 0.2;
  });
}

}  // namespace slicefarm::texture
