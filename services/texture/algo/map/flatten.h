#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Options for Flatten.
struct FlattenOptions {
  int max_iterations = 500;
  /// The iteration ends when the energy decreases by less than this share in one iteration.
  double least_drop = 1e-5;
};

/// Flat map of a surface.
struct FlatMap {
  /// Position of each vertex, in mm; a vertex that no triangle uses is at the origin.
  std::vector<Eigen::Vector2d> points_mm;
  /// Symmetric Dirichlet energy, weighted by area, divided by 4: 1 for an isometry.
  double mean_energy = 0;
  int iterations = 0;
};

/// Computes a one-to-one map of a disk with holes into the plane, without changing its scale. No
/// triangle flips, and no two parts of the map overlap. Newton's method minimizes the symmetric
/// Dirichlet energy, beginning with Tutte's embedding. The boundary is free.
///
/// The result is the same in each run, bit by bit. Errors: any error of BoundaryOfDisk; INTERNAL;
/// Cancelled. Cost: about 20 sparse factorizations with two unknowns per vertex.
///
/// Source: Su, Ye, Liu, Fu, "Efficient Bijective Parameterizations", ACM TOG 39 (2020); Liu, Ye,
/// Ni, Fu, "Progressive Parameterizations", ACM TOG 37 (2018).
absl::StatusOr<FlatMap> Flatten(const SurfaceMesh& mesh, const FlattenOptions& options = {},
                                const CancelToken& cancel = {});

}  // namespace slicefarm::texture
