#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Data of one layer of an object, kept by planning for the infill of one region.
struct StackLayer {
  int32_t job_layer = 0;
  Coord z_nm = 0;  ///< top of the layer, above the object's bottom
  Coord height_nm = 0;
  MultiPolygon whole;   ///< outlines of all regions
  MultiPolygon region;  ///< outlines of the planned region
};

/// All layers of an object, bottom up.
using ObjectStack = std::vector<StackLayer>;

}  // namespace slicefarm::planning
