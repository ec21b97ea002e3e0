#include "common/geometry/boolean/without_holes.h"

#include <vector>

#include "common/geometry/boolean/boolean.h"

namespace slicefarm {

MultiPolygon WithoutHoles(const MultiPolygon& region) {
  std::vector<Polygon> outers;
  outers.reserve(region.size());
  bool holes = false;
  for (const PolygonWithHoles& island : region) {
    holes |= !island.holes.empty();
    outers.push_back(island.outer);
  }
  return holes ? Union(outers, FillRule::kNonZero) : region;
}

}  // namespace slicefarm
