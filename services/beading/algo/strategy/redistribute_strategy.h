#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

struct RedistributeOptions {
  Coord outer_width_nm = 400'000;
  Coord min_width_nm = 340'000;  ///< of an inner bead, as long as the outer ones keep their width
  Coord max_width_nm = 800'000;  ///< no bead is ever wider
  double min_outer_share = 0.5;  ///< of the outer width: thinner places get no bead
  double split_threshold =
      0.7;  ///< of the outer width, that a lone bead grows by before it is split
  /// Two beads that are in transition to three do not get wider than the outer width.
  bool lock_outer_width = false;
};

/// Keeps the outermost two beads at their width; the parent lays out what is between them. One bead
/// or two share the thickness evenly. Where not even least beads fit between the outer ones, all
/// shrink together (upstream: beads of no width).
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
