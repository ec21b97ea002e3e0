#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Reserves a stripe along both sides, and lays the parent's beads out between the stripes. Beads
/// are laid out as rectangles, which tile (common/model/bead_section.h). In print, the outermost
/// bead bulges into the stripe, so it does not exceed the outline.
class MarginStrategy : public BeadingStrategy {
 public:
  MarginStrategy(Coord margin_nm, std::unique_ptr<const BeadingStrategy> parent)
      : margin_nm_(margin_nm), parent_(std::move(parent)) {}

  Beading Compute(Coord thickness_nm, int count) const override;
  int OptimalCount(Coord thickness_nm) const override {
    return parent_->OptimalCount(Inner(thickness_nm));
  }
  Coord OptimalThickness(int count) const override {
    return 2 * margin_nm_ + parent_->OptimalThickness(count);
  }
  Coord TransitionThickness(int lower_count) const override;
  Coord TransitionLength(int lower_count) const override {
    return parent_->TransitionLength(lower_count);
  }
  double TransitionAnchor(int lower_count) const override {
    return parent_->TransitionAnchor(lower_count);
  }
  std::vector<Coord> Kinks() const override;

 private:
  Coord Inner(Coord thickness_nm) const {
    return thickness_nm > 2 * margin_nm_ ? thickness_nm - 2 * margin_nm_ : 0;
  }

  Coord margin_nm_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

}  // namespace slicefarm::beading
