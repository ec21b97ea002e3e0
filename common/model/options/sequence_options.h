#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Printing of copies one after the other, each as a whole.
struct SequencePlanOptions {
  bool complete_objects = false;              ///< complete_objects
  Coord clearance_radius_nm = 20 * kNmPerMm;  ///< extruder_clearance_radius: around the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;  ///< extruder_clearance_height: gantry over nozzle

  friend bool operator==(const SequencePlanOptions&, const SequencePlanOptions&) = default;
};

}  // namespace slicefarm
