#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the hatch lines of a region in the order and direction of scanning, two points each.
///
///   kHatch    lines through the whole region; neighbouring lines form serpentines;
///   kStripes  lines of at most a stripe's width; shifted by half a distance in odd stripes;
///   kIslands  squares with lines along `angle_deg` in even squares and across it in odd ones.
/// Stripes and squares reach half of `overlap_nm` beyond their borders. Distances are counted from
/// the origin, so that the lines of neighbouring regions, layers and copies continue each other.
/// Lines shorter than minimum_vector_nm are omitted.
///
/// REQUIRES: options.strategy is one of the three; the options pass the checks of options_check.h.
/// Errors: REQUEST_TOO_LARGE, as CutScanLines. Cost: O(n + k log k), k lines.
absl::StatusOr<std::vector<Point>> Hatch(const HatchRegion& region, double angle_deg,
                                         const ExposureOptions& options, Point from);

}  // namespace slicefarm::exposure
