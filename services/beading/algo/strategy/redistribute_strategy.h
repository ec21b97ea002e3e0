#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options of RedistributeStrategy.
struct RedistributeOptions {
  Coord outer_width_nm = 400'000;
  /// Smallest width of an inner bead. If not even this fits, the outer beads shrink too.
  Coord min_width_nm = 340'000;
  Coord max_width_nm = 800'000;  ///< largest width of one or two beads
  /// Smallest thickness that gets a bead, as a fraction of the outer width.
  double min_outer_share = 0.5;
  double split_threshold =
      0.7;  ///< growth of a single bead before it is split, as a fraction of the outer width
  /// If true, two beads in transition to three do not become wider than the outer width.
  bool lock_outer_width = false;
};

/// Keeps the width of the outermost two beads; the parent lays out beads on the thickness between
/// them. If there are only one or two beads, they share the thickness evenly. If not even inner
/// beads of smallest width fit between the outer beads, all beads shrink together (upstream: beads
/// without width).
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
