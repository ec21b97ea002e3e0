#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/line_blocks.h"

namespace slicefarm::exposure {

/// The hatch lines of each stripe (kStripes) or island (kIslands); see hatch.h.
absl::StatusOr<LineBlocks> CellBlocks(const MultiPolygon& region, double angle_deg,
                                      const ExposureOptions& options);

}  // namespace slicefarm::exposure
