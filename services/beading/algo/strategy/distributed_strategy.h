#pragma once

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options of DistributedStrategy.
struct DistributedOptions {
  Coord optimal_width_nm = 400'000;
  /// Smallest width of a bead, if there are OptimalCount beads for the thickness.
  Coord min_width_nm = 340'000;
  Coord max_width_nm = 800'000;  ///< largest width of a bead, for any count
  /// Excess over the optimal thickness at which the middle bead of an odd count is split, as a
  /// fraction of the optimal width.
  double split_threshold = 0.7;
  /// Excess over the optimal thickness at which an even count gets a middle bead, as a fraction of
  /// the optimal width.
  double add_threshold = 0.85;
  /// Number N of beads on either side of the middle that share the excess or deficit. Their weights
  /// are 1 - (i / N)^2, with i counted from the middle.
  int distribution_count = 1;
  Coord transition_length_nm = 400'000;
};

/// Lays out beads of optimal width. The beads in the middle share the difference between the
/// thickness and the sum of these widths.
///
/// For a fixed count, each width is a piecewise linear function of the thickness. Its breakpoints
/// are the thicknesses at which:
///
/// - all beads have width 0;
/// - all beads have the smallest width;
/// - the middle bead has the smallest width, the remaining beads follow by their weights;
/// - the middle bead has the largest width, the remaining beads follow by their weights;
/// - all beads have the largest width.
///
/// If the thickness is larger still, the excess is left over in the middle. So no bead becomes
/// negative or wider than allowed. (Upstream has a negative middle bead for a few thick beads, and
/// no upper limit.)
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
