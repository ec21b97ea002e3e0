#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

enum class MoveKind : uint8_t {
  kRapid,
  kLine,
  kClockwise,         ///< an arc about a vertical axis; its z goes evenly: a helix
  kCounterClockwise,  ///< likewise
};

/// A move of the tip from where the move before ended. All numbers are whole micrometres, as a
/// program's text has them.
struct MillMove {
  MoveKind kind = MoveKind::kRapid;
  MillPhase phase = MillPhase::kRoughing;
  Eigen::Vector3d to_mm{0, 0, 0};
  Eigen::Vector2d centre_mm{0, 0};  ///< of an arc
  double feed_mm_min = 0;           ///< of a rapid move: 0
};

/// Length of a move's way.
double LengthOf(const MillMove& move, const Eigen::Vector3d& from_mm);

/// Points of a move's way from its start on, its end last, no chord farther from it than the
/// tolerance.
std::vector<Eigen::Vector3d> PointsOf(const MillMove& move, const Eigen::Vector3d& from_mm,
                                      double tolerance_mm);

}  // namespace slicefarm::milling
