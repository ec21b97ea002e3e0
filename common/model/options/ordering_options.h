#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Order and start points of the walls of one region.
struct WallOrder {
  bool external_perimeters_first = false;  ///< setting external_perimeters_first
  bool inner_outer_inner = false;  ///< `inner_outer_inner`: overrides external_perimeters_first
  /// True for brims: walls are printed from the outer edge of an island to its holes. Overrides
  /// external_perimeters_first and inner_outer_inner.
  bool towards_holes = false;
  /// `staggered_inner_seams`: each inner loop starts a little further along the wall than the loop
  /// outside of it.
  bool stagger_seams = false;
  bool whole_loops = false;  ///< true: links to other paths never cut into an inner loop

  friend bool operator==(const WallOrder&, const WallOrder&) = default;
};

/// Options for travels between paths.
struct TravelOptions {
  /// `only_retract_when_crossing_perimeters`: no retraction inside the part, because oozing is not
  /// visible there.
  bool hide = true;
  /// `retract_inside_after`: longest travel inside the part without retraction; 0: unlimited
  double longest_hidden_mm = 30;
  bool avoid_crossing = false;  ///< setting avoid_crossing_perimeters
  double max_detour_mm = 0;     ///< setting avoid_crossing_perimeters_max_detour; 0: unlimited
  /// `avoid_crossing_perimeters_max_detour` in percent of the straight line; 0: unlimited
  double max_detour_ratio = 0;
  /// `retract_layer_change`: retracts between layers even if the travel is hidden
  bool retract_layer_change = false;
  /// bed_shape without bed_exclude_area: area that travels do not leave. Empty: no area is
  /// excluded.
  MultiPolygon room = {};

  friend bool operator==(const TravelOptions&, const TravelOptions&) = default;
};

/// Job settings for ordering.
struct JobOrder {
  bool infill_first = false;  ///< setting infill_first
  /// `prefer_clockwise_movements`: outer rings run clockwise, holes counter-clockwise
  bool clockwise = false;
  TravelOptions travel;
  int32_t improvement_moves =
      /// largest number of 2-opt moves tried per layer; a number, because a time limit would make
      /// results differ
      200'000;

  friend bool operator==(const JobOrder&, const JobOrder&) = default;
};

/// Options of the ordering stage.
struct OrderingOptions : JobOrder {
  std::vector<WallOrder> walls = {{}};  ///< wall order of each region

  using Row = JobOrder;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.walls);
  }
  friend bool operator==(const OrderingOptions&, const OrderingOptions&) = default;
};

}  // namespace slicefarm
