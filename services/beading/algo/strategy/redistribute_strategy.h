#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options of RedistributeStrategy.
struct RedistributeOptions {
  Coord outer_width_nm = 400'000;
  /// Smallest width of an inner bead. If inner beads of this width do not fit, the outer beads
  /// shrink too.
  Coord min_width_nm = 340'000;
  Coord max_width_nm = 800'000;  ///< largest width of a bead if there are only one or two
  /// Smallest thickness that gets a bead, as a fraction of the outer width.
  double min_outer_share = 0.5;
  /// Excess over the outer width at which a single bead is split, as a fraction of the outer width.
  double split_threshold = 0.7;
  /// If true, two beads keep the outer width where the thickness is optimal for three beads (in a
  /// transition from two to three).
  bool lock_outer_width = false;
};

/// Keeps the width of the outermost bead on each side; the parent lays out beads on the thickness
/// between these two. One or two beads share the thickness evenly. If inner beads of smallest width
/// do not fit between the outer beads, all beads shrink by the same factor. (Upstream then has
/// beads without width.)
class RedistributeStrategy : public BeadingStrategy {
 public:
  RedistributeStrategy(const RedistributeOptions& options,
                       std::unique_ptr<const BeadingStrategy> parent)
      : options_(options), parent_(std::move(parent)) {}

  Beading Compute(Coord thickness_nm, int count) const override;
  int OptimalCount(Coord thickness_nm) const override;
  Coord OptimalThickness(int count) const override;
  Coord TransitionThickness(int lower_count) const override;
  Coord TransitionLength(int lower_count) const override;
  double TransitionAnchor(int lower_count) const override;
  std::vector<Coord> Kinks() const override;

 private:
  Coord BothOuter() const { return 2 * options_.outer_width_nm; }

  RedistributeOptions options_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

}  // namespace slicefarm::beading
