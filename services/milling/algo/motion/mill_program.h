#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/motion/mill_move.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// What the machine does, from the safe height back to it.
struct MillProgram {
  std::vector<MillMove> moves;
  double safe_z_mm = 0;
  int ways = 0;  ///< loops and runs that were cut
  double removed_mm3 = 0;
};

/// Puts the ways of all steps together: roughing, then finishing, each from the top down and pocket
/// by pocket, then rest areas. REQUIRES: `steps` are those of the job, in its order. Errors:
/// Cancelled. Cost: see StockMap::Cut.
absl::StatusOr<MillProgram> AssembleProgram(const MillingJob& job,
                                            std::span<const MilledStep> steps,
                                            const CancelToken& cancel = {});

}  // namespace slicefarm::milling
