#include "services/ordering/algo/unsupported_walls.h"

#include <algorithm>
#include <set>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "services/ordering/algo/path_key.h"
#include "services/ordering/algo/wall_groups.h"

namespace slicefarm::ordering {
namespace {

/// Half the width of the stripe that stands for a centre line.
constexpr Coord kStripeNm = 5'000;

/// Distance by which the areas over air grow. It is more than half of a stripe and its rounding.
constexpr Coord kGrowthNm = 2 * kStripeNm;

}  // namespace

bool AirBelow::IsUnder(const Path& wall) {
  if (!wall.closed) return false;
  const Box box = Bounds(wall.points);
  const MultiPolygon near = IslandsNear(box, air_, index_);
  if (!std::ranges::all_of(wall.points, [&](Point p) { return Covers(near, p); })) return false;
  if (!grown_) {
    MultiPolygon grown = Offset(air_, kGrowthNm);
    BoxIndex index(grown);
    grown_.emplace(std::move(grown), std::move(index));
  }
  Polyline line = wall.points;
  line.push_back(line.front());
  const MultiPolygon stripe = OffsetLines({&line, 1}, kStripeNm, Cap::kRound);
  return Difference(stripe, IslandsNear(box.Grown(kStripeNm), grown_->air, grown_->index)).empty();
}

std::vector<Path*> TakeUnsupported(std::vector<Path*>& walls, AirBelow& air) {
  std::vector<Path*> unsupported;
  if (air.empty()) return unsupported;
  for (const WallGroup& group : GroupWalls(SortedByGeometry(walls)))
    if (std::ranges::all_of(group.walls, [&](const Path* wall) { return air.IsUnder(*wall); }))
      unsupported.insert(unsupported.end(), group.walls.begin(), group.walls.end());
  const std::set<const Path*> taken(unsupported.begin(), unsupported.end());
  std::erase_if(walls, [&](const Path* wall) { return taken.contains(wall); });
  return unsupported;
}

}  // namespace slicefarm::ordering
