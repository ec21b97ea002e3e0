#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

struct WideningOptions {
  Coord min_feature_nm = 100'000;  ///< thinner places get no bead
  Coord min_width_nm = 340'000;    ///< of a lone bead: it leaves thinner places on both sides
};

/// Prints places that are thinner than a bead may be, with a bead of least width.
class WideningStrategy : public BeadingStrategy {
 public:
  WideningStrategy(const WideningOptions& options, std::unique_ptr<const BeadingStrategy> parent)
      : options_(options), parent_(std::move(parent)) {}

  Beading Compute(Coord thickness_nm, int count) const override;
  int OptimalCount(Coord thickness_nm) const override;
  Coord OptimalThickness(int count) const override { return parent_->OptimalThickness(count); }
  Coord TransitionThickness(int lower_count) const override;
  Coord TransitionLength(int lower_count) const override {
    return parent_->TransitionLength(lower_count);
  }
  double TransitionAnchor(int lower_count) const override {
    return parent_->TransitionAnchor(lower_count);
  }
  std::vector<Coord> Kinks() const override;

 private:
  WideningOptions options_;
  std::unique_ptr<const BeadingStrategy> parent_;
};

}  // namespace slicefarm::beading
