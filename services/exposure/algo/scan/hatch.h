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
///   kStripes  lines of at most a stripe's width; in odd stripes, shifted by half a distance;
///   kIslands  squares with lines along `angle_deg` in even squares and perpendicular in odd ones.
/// Stripes and squares extend by half of `overlap_nm` beyond their limits. Distances are counted
/// from the origin, so that the lines of neighbouring regions, layers and copies continue each
/// other. Lines shorter than minimum_vector_nm are omitted.
///
/// REQUIRES: options.strategy is one of the three; the options pass the checks of options_check.h.
/// Errors: REQUEST_TOO_LARGE for more than kMaxScanPieces. Cost: O(n + k log k), n points of the
/// region, k lines.
absl::StatusOr<std::vector<Point>> Hatch(const HatchRegion& region, double angle_deg,
                                         const ExposureOptions& options, Point from);

}  // namespace slicefarm::exposure
