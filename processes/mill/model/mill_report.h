#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "processes/mill/model/milled_step.h"

namespace slicefarm {

/// Totals of the moves of a phase.
struct PhaseReport {
  double cut_mm = 0;
  double rapid_mm = 0;
  double seconds = 0;
  int64_t moves = 0;
  int64_t arcs = 0;

  friend bool operator==(const PhaseReport&, const PhaseReport&) = default;
};

/// Statistics of a program and result of its gouge check.
struct MillReport {
  std::array<PhaseReport, kMillPhaseCount> phases;  ///< totals per MillPhase
  /// number of toolpaths that were cut: closed loops on levels, and paths along rows
  int64_t passes = 0;
  double removed_mm3 = 0;

  /// Number of checked positions of the tip: ends and midpoints of moves and of the chords of arcs.
  int64_t checked = 0;
  /// Number of checked positions where the part reaches into the cutter by more than the tolerance.
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
