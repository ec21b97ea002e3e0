#pragma once

#include <optional>
#include <span>

#include "common/kinematics/kinematic_move.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Number of moves at each end of a layer's program that LayerEdges stores, without the moves
/// before the layer's entry. The time of the whole print is computed from them (print_clock.h).
/// Moves farther inside do not depend on other layers.
inline constexpr size_t kEdgeMoves = 8;

/// Follows a program from move to move. Stores the machine's position and acceleration.
class MoveWalk {
 public:
  /// `acceleration_mm_s2`: acceleration at the start; 0: not known.
  MoveWalk(EdgeMove start, double acceleration_mm_s2)
      : at_(start), acceleration_mm_s2_(acceleration_mm_s2) {}

  /// Makes the next move and returns it. The result has the acceleration if it is known. A bead
  /// does not change z, and a lift does not change x and y.
  const EdgeMove& Go(const Move& move, ShiftUm shift);

  const EdgeMove& at() const { return at_; }
  double acceleration_mm_s2() const { return acceleration_mm_s2_; }

 private:
  EdgeMove at_;
  double acceleration_mm_s2_;
};

/// Converts a move into the form for planners. The move begins at the end of `before`. `set_mm_s2`:
/// acceleration of a move without one of its own. Returns nullopt if the machine does not move.
std::optional<KinematicMove> ToKinematic(const EdgeMove& before, const EdgeMove& move,
                                         double set_mm_s2);

/// Returns true if the move is a bead.
bool Prints(const EdgeMove& before, const EdgeMove& move);

/// Returns the first and last moves of a program, kEdgeMoves each. REQUIRES: the first span
/// starts with the first move of its toolpath.
LayerEdges EdgesOf(std::span<const MoveSpan> spans);

}  // namespace slicefarm::motion
