#pragma once

#include "absl/status/statusor.h"
#include "services/exposure/algo/scan/line_blocks.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Lines right through a region; from each the way goes on to the nearest one of the next line that
/// lies beside it. A block ends where there is none left.
absl::StatusOr<LineBlocks> SerpentineBlocks(const HatchRegion& region, double angle_deg,
                                            const ExposureOptions& options);

}  // namespace slicefarm::exposure
