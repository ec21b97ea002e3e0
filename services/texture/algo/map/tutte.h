#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// First map of a surface, from which Flatten starts.
struct FirstMap {
  /// Position of each vertex, in mm; a vertex that no triangle uses is at the origin.
  std::vector<Eigen::Vector2d> points;
  /// Centre of each hole, indexed by hole. Every edge of the hole's loop is visible from it.
  std::vector<Eigen::Vector2d> hole_middles;
};

/// Returns a first map without flips. The outer loop is on a circle with the surface's area; the
/// distances of its vertices are proportional to the edge lengths. Each other vertex is at a
/// weighted mean of its neighbours. A hole is kept open by an additional vertex in its centre.
///
/// The weights are spring constants. A few rounds adjust them, so that the lengths of edges in the
/// map are in proportion to their lengths on the surface. Plain means would shrink parts far from
/// the boundary (a head on a neck) below the precision of doubles. Any positive symmetric weights
/// give an embedding.
///
/// Errors: INTERNAL. Cost: a few sparse factorizations for n vertices. Source: W. T. Tutte 1963; M.
/// Floater 1997, theorem 4.1.
absl::StatusOr<FirstMap> TutteEmbedding(const SurfaceMesh& mesh,
                                        std::span<const BoundaryLoop> loops);

}  // namespace slicefarm::texture
