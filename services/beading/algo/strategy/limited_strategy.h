#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Limits the number of beads to `max_count`, half of them on either side. The area between the two
/// halves is left to the infill. Markers (beads of width 0) are the boundary of this area. A count
/// of max_count + 1 represents a thickness at which beads have their optimal widths and something
/// is left over between them.
///
/// REQUIRES: max_count is even.
class LimitedStrategy : public BeadingStrategy {
 public:
  LimitedStrategy(int max_count, std::unique_ptr<const BeadingStrategy> parent)
      : max_count_(max_count), parent_(std::move(parent)) {}

  Beading Compute(Coord thickness_nm, int count) const override;
  int OptimalCount(Coord thickness_nm) const override;
  Coord OptimalThickness(int count) const override;
  Coord TransitionThickness(int lower_count) const override;
  Coord TransitionLength(int lower_count) const override;
  double TransitionAnchor(int lower_count) const override;
  std::vector<Coord> Kinks() const override;

 private:
  int max_count_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

}  // namespace slicefarm::beading
