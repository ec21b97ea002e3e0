#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Positions of the tip on one level, as regions in nm.
struct FreeArea {
  /// Positions of the tip at which the cutter touches stock or is nearer to it than the clearance.
  MultiPolygon reach;
  /// Part of `reach` where the distance of the cutter from the part is at least the allowance.
  MultiPolygon free;
};

/// Returns the free areas of levels, in the order of `levels_mm`. A free area is computed from two
/// waterlines: the waterline of the stock for a cylinder wider than the cutter by the clearance,
/// minus the waterline of the part for the cutter grown by the allowance. A position that is free
/// on a level is free on all levels above. Each result depends only on its own level. Errors: any
/// error of Waterlines.
absl::StatusOr<std::vector<FreeArea>> FreeAreas(const MillingJob& job, double allowance_mm,
                                                std::span<const double> levels_mm,
                                                const CancelToken& cancel, int threads = 1);

}  // namespace slicefarm::milling
