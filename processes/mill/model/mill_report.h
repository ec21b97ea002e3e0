#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "processes/mill/model/milled_step.h"

namespace slicefarm {

/// Sums over the moves of a phase.
struct PhaseReport {
  double cut_mm = 0;
  double rapid_mm = 0;
  double seconds = 0;
  int64_t moves = 0;
  int64_t arcs = 0;

  friend bool operator==(const PhaseReport&, const PhaseReport&) = default;
};

/// What a program does, and whether it gouges.
struct MillReport {
  std::array<PhaseReport, kMillPhaseCount> phases;  ///< by MillPhase
  int64_t ways = 0;                                 ///< loops and runs that were cut
  double removed_mm3 = 0;

  /// Places of the tip that were looked at: the ends of moves and of the chords of arcs, and their
  /// middles.
  int64_t checked = 0;
  /// Of them, where the part reaches into the cutter by more than the tolerance.
  int64_t gouges = 0;
  Eigen::Vector3d first_gouge_mm{0, 0, 0};

  double Seconds() const {
    double sum = 0;
    for (const PhaseReport& phase : phases) sum += phase.seconds;
    return sum;
  }

  friend bool operator==(const MillReport&, const MillReport&) = default;
};

}  // namespace slicefarm
