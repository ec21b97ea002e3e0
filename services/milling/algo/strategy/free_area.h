#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Where the tip may be on a level, in nm.
struct FreeArea {
  /// Where the cutter may meet stock or is no farther from it than the clearance.
  MultiPolygon reach;
  /// Of it, where the cutter does not come nearer to the part than the allowance.
  MultiPolygon free;
};

/// The free areas of levels, in their order: waterlines of the stock, for a cylinder wider by the
/// clearance, less those of the part, for the cutter grown by the allowance. What is free on a
/// level is free on all above it. An area depends on its own level only. Errors: those of
/// Waterlines.
absl::StatusOr<std::vector<FreeArea>> FreeAreas(const MillingJob& job, double allowance_mm,
                                                std::span<const double> levels_mm,
                                                const CancelToken& cancel, int threads = 1);

}  // namespace slicefarm::milling
