#pragma once

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

struct DistributedOptions {
  Coord optimal_width_nm = 400'000;
  Coord min_width_nm = 340'000;  ///< of a bead, as long as the count is the optimal one
  Coord max_width_nm = 800'000;  ///< no bead is ever wider
  double split_threshold = 0.7;  ///< of a width, that the middle bead grows by before it is split
  double add_threshold = 0.85;   ///< of a width, that is free in the middle before a bead is added
  /// Beads on either side of the middle that share what is too much or too little: weights
  /// 1 - (i / N)^2, with i counted from the middle.
  int distribution_count = 1;
  Coord transition_length_nm = 400'000;
};

/// Gives what is too much or too little for n beads of the optimal width to those in the middle.
///
/// For one count each width is linear between five thicknesses: nothing; all beads of least width;
/// the middle one of least width and the others as their weights say; the middle one of greatest
/// width likewise; all of greatest width. Beyond, the rest is left over in the middle. So no bead
/// becomes negative or wider than allowed (upstream: a negative middle bead for few and thick ones,
/// and no bound above).
class DistributedStrategy : public BeadingStrategy {
 public:
  explicit DistributedStrategy(const DistributedOptions& options) : options_(options) {}

  Beading Compute(Coord thickness_nm, int count) const override;
  int OptimalCount(Coord thickness_nm) const override;
  Coord OptimalThickness(int count) const override;
  Coord TransitionThickness(int lower_count) const override;
  Coord TransitionLength(int lower_count) const override;
  double TransitionAnchor(int lower_count) const override;
  std::vector<Coord> Kinks() const override { return {}; }

 private:
  DistributedOptions options_;
};

}  // namespace slicefarm::beading
