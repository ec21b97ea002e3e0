#include "services/beading/algo/strategy/strategy_factory.h"

#include <algorithm>
#include <utility>

#include "services/beading/algo/strategy/distributed_strategy.h"
#include "services/beading/algo/strategy/inset_strategy.h"
#include "services/beading/algo/strategy/limited_strategy.h"
#include "services/beading/algo/strategy/margin_strategy.h"
#include "services/beading/algo/strategy/redistribute_strategy.h"
#include "services/beading/algo/strategy/widening_strategy.h"

namespace slicefarm::beading {
namespace {

/// Returns the growth of a bead, as a fraction of its width, after which both of its halves have
/// the smallest width.
double SplitThreshold(Coord width_nm, Coord min_width_nm) {
  const auto width = static_cast<double>(width_nm), least = static_cast<double>(min_width_nm);
  return std::clamp((2 * least - width) / width, 0.01, 0.99);
}

double AddThreshold(Coord width_nm, Coord min_width_nm) {
  return std::clamp(static_cast<double>(min_width_nm) / static_cast<double>(width_nm), 0.01, 0.99);
}

}  // namespace

std::unique_ptr<const BeadingStrategy> MakeStrategy(const StrategyOptions& options) {
  const Coord outer = options.outer_width_nm;
  // With one wall, all beads are outer ones.
  const Coord inner = options.max_walls == 1 ? outer : options.inner_width_nm;
  const Coord added = options.min_width_nm, halves = options.min_split_width_nm;
  const Coord least = std::min(added, halves);
  const Coord most = std::max({options.max_width_nm, outer, inner, least});

  std::unique_ptr<const BeadingStrategy> strategy = std::make_unique<DistributedStrategy>(
      DistributedOptions{.optimal_width_nm = inner,
                         .min_width_nm = least,
                         .max_width_nm = most,
                         .split_threshold = SplitThreshold(inner, halves),
                         .add_threshold = AddThreshold(inner, added),
                         .distribution_count = std::max(1, options.distribution_count - 1),
                         .transition_length_nm = options.transition_length_nm});
  strategy = std::make_unique<RedistributeStrategy>(
      RedistributeOptions{.outer_width_nm = outer,
                          .min_width_nm = least,
                          .max_width_nm = most,
                          .split_threshold = SplitThreshold(outer, halves),
                          .lock_outer_width = options.lock_outer_width},
      std::move(strategy));
  if (options.widen_thin_places) {
    strategy = std::make_unique<WideningStrategy>(WideningOptions{options.min_feature_nm, least},
                                                  std::move(strategy));
  }
  if (options.outer_inset_nm != 0)
    strategy =
        std::make_unique<OuterWallInsetStrategy>(options.outer_inset_nm, std::move(strategy));
  if (options.inner_inset_nm != 0)
    strategy =
        std::make_unique<InnerWallInsetStrategy>(options.inner_inset_nm, std::move(strategy));
  if (options.max_walls > 0)
    strategy = std::make_unique<LimitedStrategy>(2 * options.max_walls, std::move(strategy),
                                                 options.apart_nm);
  if (options.margin_nm > 0)
    strategy = std::make_unique<MarginStrategy>(options.margin_nm, std::move(strategy));
  return strategy;
}

}  // namespace slicefarm::beading
