#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Kind of a move.
enum class MoveKind : uint8_t {
  kRapid,
  kLine,
  kClockwise,         ///< arc about a vertical axis; z changes evenly, so it may be a helix
  kCounterClockwise,  ///< like kClockwise, in the other direction
};

/// Move of the tip from the end of the previous move. All numbers are whole micrometres, as in a
/// program's text.
struct MillMove {
  MoveKind kind = MoveKind::kRapid;
  MillPhase phase = MillPhase::kRoughing;
  Eigen::Vector3d to_mm{0, 0, 0};
  Eigen::Vector2d centre_mm{0, 0};  ///< centre of an arc
  double feed_mm_min = 0;           ///< 0 for a rapid move
};

/// Returns the length of a move.
double LengthOf(const MillMove& move, const Eigen::Vector3d& from_mm);

/// Returns points of a move, without its start, up to its end. No chord is farther from the move
/// than the tolerance.
std::vector<Eigen::Vector3d> PointsOf(const MillMove& move, const Eigen::Vector3d& from_mm,
                                      double tolerance_mm);

}  // namespace slicefarm::milling
