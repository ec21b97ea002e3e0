#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/overhang.h"

namespace slicefarm::motion {

/// A place on the way, and how far the nozzle is up there.
struct RampPlace {
  PlaceUm place;
  int32_t up_um = 0;

  friend bool operator==(const RampPlace&, const RampPlace&) = default;
};

/// How far the nozzle rises over a travel, mm: by travel_ramping_lift or straight up.
double LiftOf(const RetractionOptions& retraction);

/// Whether it rises along its way, and not straight up.
bool RisesAlongTheWay(const RetractionOptions& retraction);

/// The places of a way from `from` on which the nozzle rises by travel_slope until it is
/// travel_max_lift up, which may be never. With travel_lift_before_obstacle it is up before the way
/// meets an edge of `below`, as PrusaSlicer has it: the first one that leads out of what `from`
/// stands on does not count. `below` may be null. The last place is the way's. REQUIRES:
/// RisesAlongTheWay; the way is not empty.
/// Source: measured, PrusaSlicer 2.9; it rounds the end of the ramp off for Marlin besides.
std::vector<RampPlace> RampedWay(PlaceUm from, std::span<const PlaceUm> way,
                                 const RetractionOptions& retraction, const LayerBelow* below);

}  // namespace slicefarm::motion
