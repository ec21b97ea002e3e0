#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "services/ordering/algo/comb/edge_strips.h"
#include "services/ordering/algo/comb/travel_paths.h"

namespace slicefarm::ordering {

/// Search for travel paths that avoid curled edges, so that the nozzle does not hit them.
///
/// The first and the last 1.5 mm of a travel may cross a curled area, because beads can begin and
/// end there. The class does not know the bed's size. Therefore its travel paths stay in `bounds`,
/// a box within the bounding box of all beads.
class CurlAvoidance {
 public:
  /// Stores the curled areas, and the box `bounds` that contains all travel paths.
  CurlAvoidance(MultiPolygon curled, const Box& bounds);

  /// Returns true if the path `from`, `corners`, `to` crosses a curled area. Ignores the first and
  /// the last 1.5 mm.
  bool Meets(Point from, std::span<const Point> corners, Point to) const;

  /// Returns the corners of a short path that crosses no curled area. Returns nothing if no such
  /// path exists or the budget (in lines of sight) is spent. Cost: the cost of TravelPaths::Find.
  std::optional<std::vector<Point>> Around(Point from, Point to, WorkBudget& budget);

  /// If the path over `corners` crosses a curled area, replaces the corners by the result of
  /// Around; if there is no result, the corners stay.
  void KeepOff(Point from, Point to, WorkBudget& budget, std::vector<Point>& corners);

  /// Returns the corners of a path from PathsThrough(region), at most `longest_nm` long, that
  /// crosses no curled area. Returns nothing if no such path exists or the budget is spent.
  std::optional<std::vector<Point>> Within(TravelPaths& region, Point from, Point to,
                                           double longest_nm, WorkBudget& budget) const;

  /// Returns the path search for the region without the curled areas.
  TravelPaths PathsThrough(const MultiPolygon& region) const;

 private:
  const MultiPolygon curled_;
  const Box bounds_;
  EdgeStrips edges_;
  std::optional<TravelPaths> paths_;  ///< built on first use
};

}  // namespace slicefarm::ordering
