#pragma once

#include <array>
#include <cstddef>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/motion/mill_program.h"

namespace slicefarm::milling {

/// Sums over the moves of a stage.
struct StageReport {
  double cut_mm = 0;
  double rapid_mm = 0;
  double seconds = 0;  ///< lengths by feeds; accelerations are not in it
  size_t moves = 0;
  size_t arcs = 0;
};

/// What a program does, and whether it gouges.
struct MillReport {
  std::array<StageReport, 3> stages;  ///< by MillingStage
  int ways = 0;
  double removed_mm3 = 0;

  /// Places of the tip that were looked at: the ends of moves and of the chords of arcs, and their
  /// middles.
  size_t checked = 0;
  /// Of them, where the part reaches into the cutter by more than the tolerance.
  size_t gouges = 0;
  Eigen::Vector3d first_gouge_mm{0, 0, 0};
};

/// Sums a program and checks it against the part: exactly, by the drop cutter, for the cutter less
/// the tolerance on all sides. Errors: Cancelled. Cost: a drop for each place, on all threads.
absl::StatusOr<MillReport> ReportOf(const MillingJob& job, const MillProgram& program,
                                    const CancelToken& cancel = {});

}  // namespace slicefarm::milling
