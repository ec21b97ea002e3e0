#include "services/ordering/algo/comb/island_edges.h"

#include <iterator>
#include <numeric>

namespace slicefarm::ordering {

bool IsOuterWall(const Path& path) {
  return path.inset == 0 && (path.feature == Feature::kExternalPerimeter ||
                             path.feature == Feature::kOverhangPerimeter);
}

Coord OuterWallRadius(std::span<const Path> paths) {
  Coord sum = 0, count = 0;
  for (const Path& path : paths) {
    if (!IsOuterWall(path) || !path.closed) continue;
    sum = std::accumulate(path.widths_nm.begin(), path.widths_nm.end(), sum);
    count += std::ssize(path.widths_nm);
  }
  return count == 0 ? 0 : sum / (2 * count);
}

IslandEdges::IslandEdges(const FilledIsland& island) {
  outline_.AddRing(island.outline.outer);
  for (const Polygon& hole : island.outline.holes) outline_.AddRing(hole);
  for (const Path& wall : island.walls) {
    if (!IsOuterWall(wall)) continue;
    wall.closed ? walls_.AddRing(wall.points) : walls_.AddLine(wall.points);
  }
  outline_.Build();
  walls_.Build();
}

}  // namespace slicefarm::ordering
