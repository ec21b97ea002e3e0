#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "services/ordering/algo/comb/clear_ways.h"
#include "services/ordering/algo/comb/edge_strips.h"

namespace slicefarm::ordering {

/// Ways that keep off what has curled up, so that the nozzle does not run into it.
///
/// Within 1.5 mm of its ends a way may meet it: a bead that begins there has to be reached. Nothing
/// is known of the bed: ways keep within the room they are given, which beads enclose.
class CurledWays {
 public:
  CurledWays(MultiPolygon curled, const Box& room);

  /// Whether a way from place to place over the corners meets what has curled up.
  bool Meets(Point from, std::span<const Point> corners, Point to) const;

  /// The corners of a short way that does not; none if there is no such way, or the budget, in lines
  /// of sight, is spent. Cost: ClearWays::Find's.
  std::optional<std::vector<Point>> Around(Point from, Point to, WorkBudget& budget);

  /// Gives a way that meets it the corners of one Around, if there is one.
  void KeepOff(Point from, Point to, WorkBudget& budget, std::vector<Point>& corners);

  /// As Around, within a region.
  std::optional<std::vector<Point>> Within(ClearWays& region, Point from, Point to,
                                           double longest_nm, WorkBudget& budget) const;

  /// Ways through what is left of the region.
  ClearWays WaysThrough(const MultiPolygon& region) const;

 private:
  const MultiPolygon curled_;
  const Box room_;
  EdgeStrips edges_;
  std::optional<ClearWays> ways_;  ///< once asked for
};

}  // namespace slicefarm::ordering
