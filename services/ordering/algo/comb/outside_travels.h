#pragma once

#include <optional>

#include "common/model/layers/layer.h"
#include "services/ordering/algo/comb/clear_ways.h"
#include "services/ordering/algo/comb/edge_strips.h"

namespace slicefarm {
struct TravelOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// The ways from island to island of a section. They are in sight. With avoid_crossing a way from an
/// outer wall to an outer wall that crosses a third one, or these two in other places, goes round
/// outside of all islands if a detour that is allowed leads there; from or to anything inside an
/// island its wall must be crossed anyway.
class OutsideTravels {
 public:
  /// `section` and `options` must outlive this; of the section, its outlines only.
  OutsideTravels(const FilledSection& section, const TravelOptions& options);

  /// `budget`: for lines of sight.
  Travel Between(const Path& last, const Path& next, WorkBudget& budget);

 private:
  ClearWays& Ways();

  const FilledSection& section_;
  const TravelOptions& options_;
  Coord wall_radius_nm_ = 0;  ///< 0: no ways are looked for
  EdgeStrips walls_;
  std::optional<ClearWays> ways_;  ///< once asked for
};

}  // namespace slicefarm::ordering
