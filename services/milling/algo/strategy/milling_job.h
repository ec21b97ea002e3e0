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

/// A part, the stock that it is milled from, and how.
struct MillingJob {
  MillingOptions options;
  TriangleMesh part;
  TriangleMesh stock;
  bool stock_is_box = true;
  Eigen::AlignedBox3d part_box;
  Eigen::AlignedBox3d stock_box;
  double floor_mm = 0;          ///< the tip's lowest height
  std::vector<MillStep> steps;  ///< in this order: levels from the top down, rows by y
};

/// The sides of what rest areas are looked for in: all places at which the cutter may rest.
Eigen::AlignedBox2d RestBox(const MillingJob& job);

/// Checks a part, its stock and the options, and lays out the levels and rows.
///
/// Levels lie on the stock's bottom, on every horizontal facet of the part (as high above it as the
/// allowance) whose area at its height is a cutter's at least, and evenly between these, a stepdown
/// apart at most. `stock` empty: a box around the part. Errors: those of CheckMillingOptions;
/// MESH_EMPTY; MESH_MALFORMED for a part or a stock that is not closed, with a place; OUT_OF_RANGE
/// for a part that reaches out of the stock, or a stock farther than 1.5 m from the origin;
/// SETTING_OUT_OF_RANGE for a cutter wider than the stock, for a tool shorter than the stock is to
/// be cut deep, for a bottom above the part or below the stock; REQUEST_TOO_LARGE for too many
/// steps, or rings of a level. Cost: O(n log n) for n triangles.
absl::StatusOr<MillingJob> PrepareMilling(TriangleMesh part, std::optional<TriangleMesh> stock,
                                          const MillingOptions& options);

/// By step: about what each takes beside the others; above 0.
std::vector<int32_t> StepWeights(const MillingJob& job);

}  // namespace slicefarm::milling
