#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Moves beads towards the middle without changing their widths. Base of the two below.
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
  /// The parent's beads, those from `first` to the one before `last` of the first half and their
  /// mirror images moved, at most to the middle.
  Beading Moved(Coord thickness_nm, int count, int first, int last) const;

 private:
  Coord inset_nm_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

/// Moves the outermost two beads, as long as there are two: against bulging of the outer wall.
/// (Upstream moves only the first one.)
class OuterWallInsetStrategy : public InsetStrategy {
 public:
  using InsetStrategy::InsetStrategy;
  Beading Compute(Coord thickness_nm, int count) const override {
    return Moved(thickness_nm, count, 0, 1);
  }
};

/// Moves all beads but the outermost two: lets inner walls keep away from the outer one.
class InnerWallInsetStrategy : public InsetStrategy {
 public:
  using InsetStrategy::InsetStrategy;
  Beading Compute(Coord thickness_nm, int count) const override {
    return Moved(thickness_nm, count, 1, count);
  }
};

}  // namespace slicefarm::beading
