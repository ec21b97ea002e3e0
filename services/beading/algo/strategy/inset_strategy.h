#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Moves beads towards the middle without changing their widths. Base of OuterWallInsetStrategy and
/// InnerWallInsetStrategy.
class InsetStrategy : public BeadingStrategy {
 public:
  InsetStrategy(Coord inset_nm, std::unique_ptr<const BeadingStrategy> parent)
      : inset_nm_(inset_nm), parent_(std::move(parent)) {}

  int OptimalCount(Coord thickness_nm) const override {
    return parent_->OptimalCount(thickness_nm);
  }
  Coord OptimalThickness(int count) const override { return parent_->OptimalThickness(count); }
  Coord TransitionThickness(int lower_count) const override {
    return parent_->TransitionThickness(lower_count);
  }
  Coord TransitionLength(int lower_count) const override {
    return parent_->TransitionLength(lower_count);
  }
  double TransitionAnchor(int lower_count) const override {
    return parent_->TransitionAnchor(lower_count);
  }
  std::vector<Coord> Kinks() const override { return parent_->Kinks(); }

 protected:
  /// Returns the parent's beads, some of them moved towards the middle by the inset, but not beyond
  /// it. In the first half, beads with an index in [first, last) are moved; the second half mirrors
  /// them. A middle bead is not moved.
  Beading Moved(Coord thickness_nm, int count, int first, int last) const;

 private:
  Coord inset_nm_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

/// Moves the outermost bead on each side inwards, to prevent bulging of the outer wall. A single
/// bead is not moved. (Upstream moves only the bead on the first side.)
class OuterWallInsetStrategy : public InsetStrategy {
 public:
  using InsetStrategy::InsetStrategy;
  Beading Compute(Coord thickness_nm, int count) const override {
    return Moved(thickness_nm, count, 0, 1);
  }
};

/// Moves all beads inwards except the outermost bead on each side, so that inner walls keep a
/// distance from the outer wall.
class InnerWallInsetStrategy : public InsetStrategy {
 public:
  using InsetStrategy::InsetStrategy;
  Beading Compute(Coord thickness_nm, int count) const override {
    return Moved(thickness_nm, count, 1, count);
  }
};

}  // namespace slicefarm::beading
