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

/// One region of a section, and what lies around it.
struct RegionInput {
  const MultiPolygon& outlines;
  const MultiPolygon& section;  ///< of all regions together
  SkinNeighbours neighbours;
  int32_t layer = 0;  ///< of the job: how far the hatch has turned
  int32_t object = 0;
  int32_t settings = 0;
  Point shift = {};  ///< of a copy of the object: for places in errors
};

/// The groups of one region in the order of scanning, beginning near `from`: contours, what is
/// inside of them, skins, thin walls. Errors: Cancelled; those of Hatch and Decompose; INTERNAL
/// with layer and place for a vector outside of the compensated outline (scan/outline_check.h).
absl::StatusOr<std::vector<ExposureGroup>> ExposeRegion(const RegionInput& region,
                                                        const ExposureOptions& options, Point from,
                                                        const CancelToken& cancel,
                                                        CutCounts& counts);

}  // namespace slicefarm::exposure
