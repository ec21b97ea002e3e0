#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// What planning keeps of one of an object's layers, for the infill of one region.
struct StackLayer {
  int32_t job_layer = 0;
  Coord z_nm = 0;  ///< of the top, above the object's bottom
  Coord height_nm = 0;
  MultiPolygon whole;   ///< the outlines of all regions
  MultiPolygon region;  ///< of the one in question
};

/// An object's layers, bottom up.
using ObjectStack = std::vector<StackLayer>;

}  // namespace slicefarm::planning
