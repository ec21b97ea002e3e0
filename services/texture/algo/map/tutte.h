#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

struct FirstMap {
  std::vector<Eigen::Vector2d> points;        ///< by vertex, in mm; unused ones at the origin
  std::vector<Eigen::Vector2d> hole_middles;  ///< by hole: every edge of its loop is seen from here
};

/// A first map without flips: the outer loop on a circle of the surface's area, spaced by its
/// edges' lengths, each other vertex at a weighted mean of its neighbours; a hole is held open by a
/// vertex in its middle.
///
/// The weights are those of springs that hold each edge at its share of its length on the surface,
/// found in a few rounds: plain means shrink what is far from the boundary (a head on a neck) to
/// nothing that doubles could tell apart. Any positive symmetric weights give an embedding.
///
/// Errors: INTERNAL. Cost: a few sparse factorizations of n vertices.
/// Source: W. T. Tutte 1963; M. Floater 1997, theorem 4.1.
absl::StatusOr<FirstMap> TutteEmbedding(const SurfaceMesh& mesh,
                                        std::span<const BoundaryLoop> loops);

}  // namespace slicefarm::texture
