#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

struct FlattenOptions {
  int max_iterations = 500;
  double least_drop = 1e-5;  ///< of the energy in an iteration, relative; below: done
};

struct FlatMap {
  std::vector<Eigen::Vector2d> points_mm;  ///< by vertex; unused ones at the origin
  double mean_energy = 0;  ///< symmetric Dirichlet by area, over 4: 1 of an isometry
  int iterations = 0;
};

/// A one-to-one map of a disk with holes into the plane, at its own scale: no triangle flips, no
/// part lies upon another, and the symmetric Dirichlet energy is as small as Newton's way from
/// Tutte's embedding makes it. The boundary is free.
///
/// Same bytes on each run. Errors: BoundaryOfDisk's; INTERNAL; Cancelled. Cost: some 20 sparse
/// factorizations of two unknowns a vertex.
/// Source: Su, Ye, Liu, Fu, "Efficient Bijective Parameterizations", ACM TOG 39 (2020); Liu, Ye,
/// Ni, Fu, "Progressive Parameterizations", ACM TOG 37 (2018).
absl::StatusOr<FlatMap> Flatten(const SurfaceMesh& mesh, const FlattenOptions& options = {},
                                const CancelToken& cancel = {});

}  // namespace slicefarm::texture
