#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/options/cutter.h"
#include "services/milling/algo/mesh/triangle_mesh.h"

namespace slicefarm::milling {

struct WaterlineOptions {
  double sampling_mm = 0.2;  ///< distance of fibers
  /// Fibers are put between those of the grid where a loop leaves the chord of two points by more;
  /// 0: nowhere.
  double tolerance_mm = 0;
  double least_sampling_mm = 0.01;  ///< but no points nearer than this
  bool contacts = false;            ///< wanted
  int threads = 1;
};

/// A way of the cutter's tip around what it must not gouge: at every point it touches the mesh. The
/// part is on its left: outer loops run counter-clockwise, inner ones clockwise.
struct WaterlineLoop {
  double z_mm = 0;
  bool outer = true;
  std::vector<Eigen::Vector2d> points_mm;    ///< closed without repeating the first
  std::vector<Eigen::Vector3d> contacts_mm;  ///< by point, on the mesh; empty: not asked for
};

/// The waterlines of a mesh on many levels, by level, in the order given: contours of where the tip
/// may not be, on a grid of fibers in x and y over the mesh and two radii around it. What is
/// thinner than the grid, and free places narrower than it, are not seen.
///
/// The pitch is that of OpenCAMlib: the least that is at or above sampling_mm and divides the
/// width. Errors: MESH_EMPTY; SETTING_OUT_OF_RANGE for a sampling or a level that is no sound
/// number; REQUEST_TOO_LARGE for too many fibers or levels; Cancelled. Cost: see PushFibers.
/// Source: OpenCAMlib's push cutter, "Weave" by A. Wallin.
absl::StatusOr<std::vector<std::vector<WaterlineLoop>>> Waterlines(
    const TriangleMesh& mesh, const Cutter& cutter, std::span<const double> levels_mm,
    const WaterlineOptions& options, const CancelToken& cancel = {});

}  // namespace slicefarm::milling
