#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// The order of the walls of one region, and where they start.
struct WallOrder {
  bool external_perimeters_first = false;  ///< external_perimeters_first
  bool inner_outer_inner = false;          ///< inner_outer_inner: goes before the one above
  /// From the outer edge of an island to its holes: brims. Goes before both.
  bool towards_holes = false;
  /// staggered_inner_seams: each inner loop starts further along than the one outside of it.
  bool stagger_seams = false;
  bool whole_loops = false;  ///< no link to another path takes from an inner loop

  friend bool operator==(const WallOrder&, const WallOrder&) = default;
};

/// How the nozzle goes from path to path.
struct TravelOptions {
  /// only_retract_when_crossing_perimeters: what oozes out inside the part is not seen.
  bool hide = true;
  double longest_hidden_mm = 30;      ///< retract_inside_after; 0: however long
  bool avoid_crossing = false;        ///< avoid_crossing_perimeters
  double max_detour_mm = 0;           ///< avoid_crossing_perimeters_max_detour; 0: however long
  double max_detour_ratio = 0;        ///< the same in percent of the straight way; 0: however long
  bool retract_layer_change = false;  ///< retract_layer_change: even if the way is hidden
  /// bed_shape without bed_exclude_area: travel stays in it; empty: nothing is excluded.
  MultiPolygon room = {};

  friend bool operator==(const TravelOptions&, const TravelOptions&) = default;
};

/// Settings of a job that ordering needs.
struct JobOrder {
  bool infill_first = false;  ///< infill_first
  bool clockwise = false;     ///< prefer_clockwise_movements: outer rings; holes the other way
  TravelOptions travel;
  int32_t improvement_moves =
      200'000;  ///< bound on the 2-opt moves tried per layer: work, not time

  friend bool operator==(const JobOrder&, const JobOrder&) = default;
};

/// Options of the ordering stage.
struct OrderingOptions : JobOrder {
  std::vector<WallOrder> walls = {{}};  ///< order in each region

  using Row = JobOrder;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.walls);
  }
  friend bool operator==(const OrderingOptions&, const OrderingOptions&) = default;
};

}  // namespace slicefarm
