#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "processes/mill/model/milled_step.h"
#include "processes/mill/model/milling_options.h"
#include "services/milling/algo/mesh/triangle_mesh.h"

namespace slicefarm::milling {

/// Part to mill, its stock, and the options.
struct MillingJob {
  MillingOptions options;
  TriangleMesh part;
  TriangleMesh stock;
  bool stock_is_box = true;
  Eigen::AlignedBox3d part_box;
  Eigen::AlignedBox3d stock_box;
  double floor_mm = 0;          ///< lowest height of the tip
  std::vector<MillStep> steps;  ///< steps: levels from the top down, rows by ascending y
};

/// Returns the bounding box of all tip positions at which the lowered cutter may touch the part,
/// seen from above. Rest areas are searched in it.
Eigen::AlignedBox2d RestBox(const MillingJob& job);

/// Checks a part, its stock and the options, and determines the levels and rows.
///
/// Levels are on the stock's bottom, and on every horizontal facet of the part that is at least as
/// large as the cutter (above the facet by the allowance). More levels are evenly spaced between
/// these, at most a stepdown apart. An empty `stock` means a box around the part.
///
/// Errors: any error of CheckMillingOptions, and
///   MESH_EMPTY
///   MESH_MALFORMED        a part or a stock that is not closed, with the position
///   OUT_OF_RANGE          a part that extends beyond the stock; a stock farther than 1.5 m from
///                         the origin
///   SETTING_OUT_OF_RANGE  a cutter wider than the stock; a tool shorter than the depth of cut in
///                         the stock; a bottom above the part or below the stock
///   REQUEST_TOO_LARGE     too many steps, or rings of a level
///
/// Cost: O(n log n) for n triangles.
absl::StatusOr<MillingJob> PrepareMilling(TriangleMesh part, std::optional<TriangleMesh> stock,
                                          const MillingOptions& options);

/// Returns the approximate cost of each step relative to the other steps; above 0.
std::vector<int32_t> StepWeights(const MillingJob& job);

}  // namespace slicefarm::milling
