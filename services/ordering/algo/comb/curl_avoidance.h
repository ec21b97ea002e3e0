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
/// Within 1.5 mm of its ends a travel may cross a curled area, because the nozzle has to reach a
/// bead that begins there. The bed's size is unknown here: travel paths stay in the given `room`,
/// which is the bounding box of beads.
class CurlAvoidance {
 public:
  /// Stores the curled areas, and the box `room` that contains all travel paths.
  CurlAvoidance(MultiPolygon curled, const Box& room);

  /// Returns true if the path `from`, corners, `to` crosses a curled area.
  bool Meets(Point from, std::span<const Point> corners, Point to) const;

  /// Returns the corners of a short path that crosses no curled area. Returns nothing if no such
  /// path exists or the budget (in lines of sight) is spent. Cost: the cost of TravelPaths::Find.
  std::optional<std::vector<Point>> Around(Point from, Point to, WorkBudget& budget);

  /// If the path over `corners` crosses a curled area, replaces the corners by the result of
  /// Around; if there is no result, the corners stay.
  void KeepOff(Point from, Point to, WorkBudget& budget, std::vector<Point>& corners);

  /// Returns the corners of a path within `region` that crosses no curled area and is at most
  /// `longest_nm` long. Returns nothing if no such path exists or the budget is spent.
  std::optional<std::vector<Point>> Within(TravelPaths& region, Point from, Point to,
                                           double longest_nm, WorkBudget& budget) const;

  /// Returns the path search for the region without the curled areas.
  TravelPaths PathsThrough(const MultiPolygon& region) const;

 private:
  const MultiPolygon curled_;
  const Box room_;
  EdgeStrips edges_;
  std::optional<TravelPaths> paths_;  ///< built on first use
};

}  // namespace slicefarm::ordering
