#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// Options of polyholes: round holes that become polygons, so that the plastic does not narrow
/// them. Member comments begin with the name of the setting.
struct PolyholeOptions {
  bool on = false;  ///< setting hole_to_polyhole
  /// `hole_to_polyhole_threshold`: largest distance of a hole's points from a circle; 0:
  /// threshold_share applies
  Coord threshold_nm = 10'000;
  double threshold_share = 0;  ///< share of the circle's radius, if given as a percentage
  bool twisted = true;         ///< setting hole_to_polyhole_twisted
  int32_t max_edges = 0;       ///< setting hole_to_polyhole_max_edges; 0: no limit
  Coord nozzle_nm = 400'000;   ///< setting nozzle_diameter

  friend bool operator==(const PolyholeOptions&, const PolyholeOptions&) = default;
};

/// Options that make overhangs printable by material below them. Member comments begin with the
/// name of the setting.
struct PrintableOverhangs {
  bool on = false;                         ///< setting make_overhang_printable
  double angle_rad = 0.95993108859688125;  ///< `make_overhang_printable_angle`: 55 degrees
  double hole_mm2 = 0;                     ///< setting make_overhang_printable_hole_size

  friend bool operator==(const PrintableOverhangs&, const PrintableOverhangs&) = default;
};

}  // namespace slicefarm
