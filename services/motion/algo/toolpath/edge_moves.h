#pragma once

#include <optional>
#include <span>

#include "common/kinematics/kinematic_move.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// So many moves at each end of a layer, those up to its entry not counted, are told to those who
/// put the print together: what happens farther inside does not depend on other layers.
inline constexpr size_t kEdgeMoves = 8;

/// Follows a program from move to move: where the machine is, and the acceleration it is set to.
class MoveWalk {
 public:
  /// `acceleration_mm_s2`: at the start; 0: not known.
  MoveWalk(EdgeMove start, double acceleration_mm_s2)
      : at_(start), acceleration_mm_s2_(acceleration_mm_s2) {}

  /// The next move, with the acceleration that it runs with as far as that is known. Beads
  /// keep their height, lifts their place.
  const EdgeMove& Go(const Move& move, ShiftUm shift);

  const EdgeMove& at() const { return at_; }
  double acceleration_mm_s2() const { return acceleration_mm_s2_; }

 private:
  EdgeMove at_;
  double acceleration_mm_s2_;
};

/// As planners see a move from where `before` ends; `set_mm_s2`: with which acceleration if it has
/// none of its own. Nothing if it does not move.
std::optional<KinematicMove> ToKinematic(const EdgeMove& before, const EdgeMove& move,
                                         double set_mm_s2);

/// Whether it is a bead.
bool Prints(const EdgeMove& before, const EdgeMove& move);

/// The moves at both ends of a program. REQUIRES: the first stretch begins its toolpath.
LayerEdges EdgesOf(std::span<const Stretch> stretches);

}  // namespace slicefarm::motion
