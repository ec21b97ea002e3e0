#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options of WideningStrategy.
struct WideningOptions {
  Coord min_feature_nm = 100'000;  ///< smallest thickness that gets a bead
  /// Smallest width of a single bead. In a thinner part the bead extends beyond both sides.
  Coord min_width_nm = 340'000;
};

/// Gives a part thinner than the smallest bead one bead of the smallest width. Parts thinner than
/// `min_feature_nm` get no bead.
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
