#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/engrave_plan.h"

namespace slicefarm::texture {

/// Position of the tool's tip.
struct ToolPoint {
  Eigen::Vector3d place_mm;
  /// normal of the surface at the point; the tool points in the opposite direction
  Eigen::Vector3d normal;
  bool on = false;  ///< true if the tool works on the path to this point; false: the path is a link
};

/// Path of the tool in one layer.
struct LayerPath {
  int32_t layer = 0;     ///< index of the layer, counted from the texture's base
  double height_mm = 0;  ///< height of the layer above the texture's base
  double offset_mm = 0;  ///< offset from the surface along its normal; negative: below the surface
  double spacing_mm = 0;
  std::vector<ToolPoint> points = {};  ///< points in order of travel; a link leads to the first one
  int64_t runs = 0;                    ///< number of worked parts of lines
  double on_mm = 0;
  double off_mm = 0;
  double section_mm2 = 0;  ///< area of the texture's section at this height, in one tile
  /// Number of folds: positions where a lifted path runs backwards, because the surface bends more
  /// sharply than the offset allows.
  int64_t folds = 0;
  double folds_mm = 0;  ///< length of the path at folds, measured on the surface
  Eigen::Vector3d first_fold_mm = Eigen::Vector3d::Zero();
};

/// Returns the paths of the layers [first, end), counted in the order of work
/// (EngravePlan::LayerAt). Their lines lead back and forth over the surface, lifted along its
/// normals. Each layer is independent of the other layers of the call. Errors: REQUEST_TOO_LARGE
/// for more lines than limits::kMaxLinesPerFill or more points in a layer than
/// limits::kMaxPointsPerLayer; Cancelled. Cost: O(triangles that each line passes + sides of the
/// section near the line).
absl::StatusOr<std::vector<LayerPath>> LayerPaths(const EngravePlan& plan, int32_t first,
                                                  int32_t end, const CancelToken& cancel = {});

/// Returns the distance between neighbouring lines of the first layer on the surface, for each
/// triangle. Weighted by the surface's area, the distances show how even the lines are.
absl::StatusOr<std::vector<double>> LineDistances(const EngravePlan& plan,
                                                  const CancelToken& cancel = {});

}  // namespace slicefarm::texture
