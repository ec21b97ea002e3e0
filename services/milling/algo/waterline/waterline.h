#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/options/cutter.h"
#include "services/milling/algo/mesh/triangle_mesh.h"

namespace slicefarm::milling {

/// Options for Waterlines.
struct WaterlineOptions {
  double sampling_mm = 0.2;  ///< distance between fibers
  /// Largest deviation of a loop from the chord between two of its points. Where it is larger,
  /// points on additional fibers are inserted. 0: no points are inserted.
  double tolerance_mm = 0;
  double least_sampling_mm = 0.01;  ///< smallest distance between inserted points
  bool contacts = false;            ///< true to compute WaterlineLoop::contacts_mm
  int threads = 1;
};

/// Closed path of the cutter's tip around a gouged area: at every point of the path the cutter
/// touches the mesh. The gouged area is on the left of the path: outer loops run counter-clockwise,
/// loops around free areas inside it clockwise.
struct WaterlineLoop {
  double z_mm = 0;
  bool outer = true;
  /// points of the closed path; the first point is not repeated
  std::vector<Eigen::Vector2d> points_mm;
  /// Contact on the mesh for each point; empty if not requested.
  std::vector<Eigen::Vector3d> contacts_mm;
};

/// Returns the waterlines of a mesh, one vector of loops per level, in the order of the levels.
/// Waterlines are contours of the area forbidden to the tip. The grid of fibers in x and y covers
/// the mesh and a margin of two cutter radii. Details thinner than the grid and free areas narrower
/// than the grid are not detected.
///
/// As in OpenCAMlib, the distance of fibers is the smallest value that is at least sampling_mm and
/// divides the grid's width. Errors: MESH_EMPTY; SETTING_OUT_OF_RANGE for an invalid sampling or
/// level; REQUEST_TOO_LARGE for too many fibers or levels; Cancelled. Cost: see PushFibers. Source:
/// OpenCAMlib's push cutter, "Weave" by A. Wallin.
absl::StatusOr<std::vector<std::vector<WaterlineLoop>>> Waterlines(
    const TriangleMesh& mesh, const Cutter& cutter, std::span<const double> levels_mm,
    const WaterlineOptions& options, const CancelToken& cancel = {});

}  // namespace slicefarm::milling
