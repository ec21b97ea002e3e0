#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"
#include "services/exposure/algo/scan/skins.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// One region of a section, and its surroundings.
struct RegionInput {
  const MultiPolygon& outlines;
  const MultiPolygon& section;  ///< outlines of all regions of the section together
  SkinNeighbours neighbours;
  int32_t layer = 0;  ///< index of the layer in the job; it sets the rotation of the hatch
  int32_t object = 0;
  int32_t settings = 0;
  Point shift = {};  ///< shift of a copy of the object, for positions in errors
};

/// Returns the groups of one region in the order of scanning, beginning near `from`: contours,
/// hatch or rings, skins, thin walls. Adds the cuts into convex pieces to `counts`. Errors:
/// Cancelled; REQUEST_TOO_LARGE (Hatch); REQUEST_MALFORMED (Decompose); INTERNAL with layer and
/// position for a vector outside of the compensated outline (scan/outline_check.h).
absl::StatusOr<std::vector<ExposureGroup>> ExposeRegion(const RegionInput& region,
                                                        const ExposureOptions& options, Point from,
                                                        const CancelToken& cancel,
                                                        CutCounts& counts);

}  // namespace slicefarm::exposure
