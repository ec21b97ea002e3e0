#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/overhang.h"

namespace slicefarm::motion {

/// Point of a travel, and the height of the nozzle above the layer at this point.
struct RampPoint {
  PointUm point;
  int32_t up_um = 0;

  friend bool operator==(const RampPoint&, const RampPoint&) = default;
};

/// Returns the largest rise of the nozzle over a travel, in mm: travel_max_lift if
/// travel_ramping_lift is on, otherwise retract_lift.
double LiftOf(const RetractionOptions& retraction);

/// Returns true if the nozzle rises along the travel and not straight up.
bool RisesAlongTravel(const RetractionOptions& retraction);

/// Returns the points of a travel from `from`. The nozzle first rises to travel_max_lift, on a
/// circle with the slope travel_slope. The circle begins and ends in the direction of the travel.
/// REQUIRES: RisesAlongTravel; `travel` is not empty.
std::vector<RampPoint> SpiralledTravel(PointUm from, std::span<const PointUm> travel,
                                       const RetractionOptions& retraction);

/// Returns the points of a travel from `from`, along which the nozzle rises with the angle
/// travel_slope up to travel_max_lift. On a short travel the nozzle does not reach this height.
///
/// With travel_lift_before_obstacle the nozzle is at full height before the travel crosses an
/// outline of `below`, the layer below (null: none). As in PrusaSlicer, the crossing by which the
/// travel leaves the island below `from` does not count. The last point is the end of the travel.
/// REQUIRES: RisesAlongTravel; `travel` is not empty. Source: measured, PrusaSlicer 2.9.
/// PrusaSlicer also rounds the end of the ramp for Marlin.
std::vector<RampPoint> RampedTravel(PointUm from, std::span<const PointUm> travel,
                                    const RetractionOptions& retraction, const LayerBelow* below);

}  // namespace slicefarm::motion
