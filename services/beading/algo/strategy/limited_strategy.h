#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Limits the number of beads to `max_count`, half of them on either side. In thicker parts, the
/// area between the two halves is left to the infill, and markers (beads of width 0) are its
/// boundary. The count max_count + 1 represents these thicker parts: `max_count` beads of optimal
/// width with an area between the halves.
///
/// Where something is left over, the beads except the outermost ones are moved inwards by
/// `apart_nm`, or by as much as is left over.
///
/// REQUIRES: max_count is even.
class LimitedStrategy : public BeadingStrategy {
 public:
  LimitedStrategy(int max_count, std::unique_ptr<const BeadingStrategy> parent, Coord apart_nm = 0)
      : max_count_(max_count), parent_(std::move(parent)), apart_nm_(apart_nm) {}

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
  Coord apart_nm_;
};

}  // namespace slicefarm::beading
