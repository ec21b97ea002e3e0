#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Sequential printing: each copy is completed before the next one begins.
struct SequencePlanOptions {
  bool complete_objects = false;  ///< setting complete_objects
  /// `extruder_clearance_radius`: free radius around the nozzle
  Coord clearance_radius_nm = 20 * kNmPerMm;
  /// `extruder_clearance_height`: height of the gantry above the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;

  friend bool operator==(const SequencePlanOptions&, const SequencePlanOptions&) = default;
};

}  // namespace slicefarm
