#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::beading {

/// Walls of one island, and the area left for the infill.
struct IslandBeads {
  std::vector<Path> walls;  ///< walls and gap fill, in no particular order
  MultiPolygon fill_area;
};

}  // namespace slicefarm::beading
