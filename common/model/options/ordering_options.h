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
  /// True for brims: walls are printed from the outer boundary of an island towards its holes.
  /// Overrides external_perimeters_first and inner_outer_inner.
  bool towards_holes = false;
  /// `staggered_inner_seams`: each inner loop starts a little further along the wall than the next
  /// loop outside of it.
  bool stagger_seams = false;
  /// `unsupported_wall_last`: walls over air that touch no other wall are printed after the fills
  bool unsupported_last = false;
  bool whole_loops = false;  ///< true: inner loops are never cut open to link them to other paths

  friend bool operator==(const WallOrder&, const WallOrder&) = default;
};

/// Options for travels between paths.
struct TravelOptions {
  /// `only_retract_when_crossing_perimeters`: travels inside the part have no retraction, because
  /// oozing is not visible there.
  bool hide = true;
  /// `retract_inside_after`: longest travel inside the part without retraction; 0: unlimited
  double longest_hidden_mm = 30;
  bool avoid_crossing = false;  ///< setting avoid_crossing_perimeters
  double max_detour_mm = 0;     ///< setting avoid_crossing_perimeters_max_detour; 0: unlimited
  /// `avoid_crossing_perimeters_max_detour` as a percentage: share of the straight line's length (1
  /// = 100 %); 0: unlimited
  double max_detour_ratio = 0;
  /// `retract_layer_change`: retracts between layers even if the travel is hidden
  bool retract_layer_change = false;
  /// `avoid_crossing_curled_overhangs`: travels avoid SectionPlan::curled
  bool avoid_curled = false;
  /// bed_shape without bed_exclude_area: area that travels do not leave. Empty: no area is
  /// excluded.
  MultiPolygon travel_area = {};

  friend bool operator==(const TravelOptions&, const TravelOptions&) = default;
};

/// Job settings for ordering.
struct JobOrder {
  bool infill_first = false;  ///< setting infill_first
  /// `prefer_clockwise_movements`: walls of outer rings are printed clockwise, walls of holes
  /// counter-clockwise
  bool clockwise = false;
  bool as_listed = false;  ///< `print_order = as_obj_list`: copies in the order of the plate
  TravelOptions travel;
  int32_t improvement_moves =
      /// largest number of 2-opt moves that are tried per layer; a time limit instead would make
      /// results depend on the machine
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
