#pragma once

#include "absl/status/statusor.h"
#include "services/exposure/algo/scan/line_blocks.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns lines through the whole region as blocks. Within a block, each line is followed by the
/// nearest line beside it on the next row. A block ends if there is no line beside its last one.
absl::StatusOr<LineBlocks> SerpentineBlocks(const HatchRegion& region, double angle_deg,
                                            const ExposureOptions& options);

}  // namespace slicefarm::exposure
