#pragma once

#include "absl/status/statusor.h"
#include "services/exposure/algo/scan/line_blocks.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the hatch lines of each stripe (kStripes) or island (kIslands) as blocks; see hatch.h.
absl::StatusOr<LineBlocks> CellBlocks(const HatchRegion& region, double angle_deg,
                                      const ExposureOptions& options);

}  // namespace slicefarm::exposure
