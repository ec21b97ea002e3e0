#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/engrave_plan.h"

namespace slicefarm::texture {

/// A place of the tool's tip.
struct ToolPoint {
  Eigen::Vector3d place_mm;
  Eigen::Vector3d normal;  ///< of the surface below: the tool's direction, backwards
  bool on = false;         ///< whether the way to this point is worked
};

struct LayerPath {
  int32_t layer = 0;     ///< from the texture's base
  double height_mm = 0;  ///< in the texture
  double offset_mm = 0;  ///< above the surface
  double spacing_mm = 0;
  std::vector<ToolPoint> points = {};  ///< in order of travel; the first one is reached by a link
  int64_t runs = 0;                    ///< of lines
  double on_mm = 0;
  double off_mm = 0;
  double section_mm2 = 0;  ///< of a tile
  /// Ways whose lift turns them back: the surface bends more there than the offset allows.
  int64_t folds = 0;
  double folds_mm = 0;  ///< on the surface
  Eigen::Vector3d first_fold_mm = Eigen::Vector3d::Zero();
};

/// The layers that are worked as the first-th to the one before end, in order of work: lines to and
/// fro over the surface, lifted along its normals. No layer depends on the others of the call.
/// Errors: REQUEST_TOO_LARGE for more lines than limits::kMaxLinesPerFill or more points in a layer
/// than limits::kMaxPointsPerLayer; Cancelled. Cost: O(triangles each line passes + sides of the
/// section near it).
absl::StatusOr<std::vector<LayerPath>> LayerPaths(const EngravePlan& plan, int32_t first,
                                                  int32_t end, const CancelToken& cancel = {});

/// Distances between neighbouring lines on the surface, by triangle, as the first layer's lines
/// have them; by the surface's area they tell how even the lines lie.
absl::StatusOr<std::vector<double>> LineDistances(const EngravePlan& plan,
                                                  const CancelToken& cancel = {});

}  // namespace slicefarm::texture
