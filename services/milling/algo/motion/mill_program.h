#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/motion/mill_move.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// Complete machine program. It begins and ends at the safe height.
struct MillProgram {
  std::vector<MillMove> moves;
  double safe_z_mm = 0;
  int passes = 0;  ///< number of passes and rest-area runs that are cut
  double removed_mm3 = 0;
};

/// Combines the passes of all steps in this order: roughing, finishing, rest areas. Roughing and
/// finishing go from the top down, pocket by pocket. REQUIRES: `steps` are all steps of the job, in
/// the job's order. Errors: Cancelled. Cost: see StockMap::Cut.
absl::StatusOr<MillProgram> AssembleProgram(const MillingJob& job,
                                            std::span<const MilledStep> steps,
                                            const CancelToken& cancel = {});

}  // namespace slicefarm::milling
