#pragma once

#include <cstdint>
#include <map>

#include "common/geometry/polygon.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm::planning {

/// Plans the area of each part's section with neither the part nor a support below it, so that
/// walls in this area can wait for the infill (unsupported_wall_last). The lowest layer of a part
/// has no such area. Memory: one outline per object.
class AirPlanner : public Planner {
 public:
  void Look(const SlicedLayer& layer, LayerPlan& plan) override;

 private:
  std::map<int32_t, MultiPolygon> below_;  ///< outline of each object in its last layer
};

}  // namespace slicefarm::planning
