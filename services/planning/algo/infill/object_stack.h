#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// One layer of an object, as input of the planning of one region's infill.
struct StackLayer {
  int32_t job_layer = 0;
  Coord z_nm = 0;  ///< top of the layer, above the object's bottom
  Coord height_nm = 0;
  MultiPolygon whole;   ///< outlines of all regions
  MultiPolygon region;  ///< outlines of the planned region
};

/// All layers of an object, lowest first.
using ObjectStack = std::vector<StackLayer>;

}  // namespace slicefarm::planning
