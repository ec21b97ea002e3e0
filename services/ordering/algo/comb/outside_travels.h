#pragma once

#include <optional>

#include "common/model/layers/layer.h"
#include "services/ordering/algo/comb/edge_strips.h"
#include "services/ordering/algo/comb/travel_paths.h"

namespace slicefarm {
struct TravelOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// Travels from island to island of a section. They are not hidden, so they need a retraction.
///
/// With avoid_crossing, a travel from one outer wall to another makes a detour outside of all
/// islands if a permitted detour exists. The detour is made if the straight line crosses any outer
/// wall between its two ends. A travel from or to a path inside an island makes no detour, because
/// it has to cross the island's wall anyway.
class OutsideTravels {
 public:
  /// Keeps references: `options` and the outlines of `section` must outlive this object.
  OutsideTravels(const FilledSection& section, const TravelOptions& options);

  /// Returns the travel from `last` to `next`. `budget`: number of lines of sight.
  Travel Between(const Path& last, const Path& next, WorkBudget& budget);

 private:
  TravelPaths& Routes();

  const FilledSection& section_;
  const TravelOptions& options_;
  /// Distance from outlines to the outer walls' centre lines; 0: no detours are searched.
  Coord wall_radius_nm_ = 0;
  EdgeStrips walls_;
  std::optional<TravelPaths> paths_;  ///< built on first use
};

}  // namespace slicefarm::ordering
