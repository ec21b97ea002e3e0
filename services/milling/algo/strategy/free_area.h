#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Free area of the tip on a level, in nm.
struct FreeArea {
  /// Area where the cutter may meet stock or is at most the clearance away from it.
  MultiPolygon reach;
  /// Part of `reach` where the cutter keeps the allowance to the part.
  MultiPolygon free;
};

/// Returns the free areas of levels, in their order. They are waterlines of the stock for a
/// cylinder widened by the clearance, minus waterlines of the part for the cutter grown by the
/// allowance. An area that is free on a level is free on all levels above. Each result depends only
/// on its own level. Errors: the errors of Waterlines.
absl::StatusOr<std::vector<FreeArea>> FreeAreas(const MillingJob& job, double allowance_mm,
                                                std::span<const double> levels_mm,
                                                const CancelToken& cancel, int threads = 1);

}  // namespace slicefarm::milling
