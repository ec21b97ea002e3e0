#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::beading {

/// One island's walls, and what they leave for the infill.
struct IslandBeads {
  std::vector<Path> walls;  ///< walls and gap fill, in no particular order
  MultiPolygon fill_area;
};

}  // namespace slicefarm::beading
