#include "services/ordering/algo/unsupported_walls.h"

#include <algorithm>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/covers.h"
#include "common/geometry/offset/offset.h"
#include "services/ordering/algo/path_key.h"
#include "services/ordering/algo/wall_groups.h"

namespace slicefarm::ordering {
namespace {

/// Half the width of the stripe that stands for a centre line.
constexpr Coord kStripeNm = 5'000;

bool IsOverAir(const Path& wall, const MultiPolygon& air, const MultiPolygon& grown) {
  if (!wall.closed) return false;
  if (!std::ranges::all_of(wall.points, [&](Point p) { return Covers(air, p); })) return false;
  Polyline line = wall.points;
  line.push_back(line.front());
  const MultiPolygon stripe = OffsetLines({&line, 1}, kStripeNm, Cap::kRound);
  return Difference(stripe, grown).empty();
}

}  // namespace

std::vector<Path*> TakeUnsupported(std::vector<Path*>& walls, const MultiPolygon& air) {
  std::vector<Path*> unsupported;
  if (air.empty()) return unsupported;
  const MultiPolygon grown = Offset(air, 2 * kStripeNm);
  for (const WallGroup& group : GroupWalls(SortedByGeometry(walls)))
    if (std::ranges::all_of(group.walls,
                            [&](const Path* wall) { return IsOverAir(*wall, air, grown); }))
      unsupported.insert(unsupported.end(), group.walls.begin(), group.walls.end());
  std::erase_if(walls, [&](Path* wall) { return std::ranges::count(unsupported, wall) > 0; });
  return unsupported;
}

}  // namespace slicefarm::ordering
