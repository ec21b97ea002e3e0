#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Sequential printing: each copy is completed before the next one begins.
struct SequencePlanOptions {
  bool complete_objects = false;  ///< setting complete_objects
  /// `extruder_clearance_radius`: radius around the nozzle in which printed objects must not be
  Coord clearance_radius_nm = 20 * kNmPerMm;
  /// `extruder_clearance_height`: height of the gantry above the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;
  /// `extruder_clearance_height_to_lid`: height of the lid above the nozzle; 0: no lid. Without a
  /// lid, the gantry covers the whole plate, and gantry_reach_nm has no effect.
  Coord lid_height_nm = 0;
  /// `extruder_clearance_dist_to_rod`: reach of the gantry in y from the nozzle
  Coord gantry_reach_nm = 0;
  Coord nozzle_height_nm = 0;  ///< `nozzle_height`: free height of the nozzle below the head

  friend bool operator==(const SequencePlanOptions&, const SequencePlanOptions&) = default;
};

}  // namespace slicefarm
