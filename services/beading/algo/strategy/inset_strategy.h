#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Moves beads towards the middle without changing their widths. Base of the two classes below.
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
  /// Returns the parent's beads with some of them moved, at most to the middle: in the first half,
  /// the beads from index `first` to before `last`, and their mirror images.
  Beading Moved(Coord thickness_nm, int count, int first, int last) const;

 private:
  Coord inset_nm_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

/// Moves the outermost two beads, if there are at least two, to prevent bulging of the outer wall.
/// (Upstream moves only the first one.)
class OuterWallInsetStrategy : public InsetStrategy {
 public:
  using InsetStrategy::InsetStrategy;
  Beading Compute(Coord thickness_nm, int count) const override {
    return Moved(thickness_nm, count, 0, 1);
  }
};

/// Moves all beads except the outermost two, so that inner walls keep a distance from the outer
/// wall.
class InnerWallInsetStrategy : public InsetStrategy {
 public:
  using InsetStrategy::InsetStrategy;
  Beading Compute(Coord thickness_nm, int count) const override {
    return Moved(thickness_nm, count, 1, count);
  }
};

}  // namespace slicefarm::beading
