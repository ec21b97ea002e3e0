#include "services/beading/algo/arachne/facing_sides.h"

#include <algorithm>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/vector.h"

namespace slicefarm::beading {
namespace {

struct Side {
  Vector2 from, to;
};

/// Returns the edges of an island, relative to its first point. The island is on their left.
std::vector<Side> SidesOf(const PolygonWithHoles& island) {
  std::vector<Side> sides;
  const Point origin = island.outer[0];
  const auto append = [&](const Polygon& ring) {
    Vector2 from = ToVector(ring.back() - origin);
    for (const Point p : ring) {
      const Vector2 to = ToVector(p - origin);
      sides.push_back({from, to});
      from = to;
    }
  };
  append(island.outer);
  std::ranges::for_each(island.holes, append);
  return sides;
}

double Length(const std::vector<Side>& sides) {
  double length = 0;
  for (const Side& side : sides) length += Norm(side.to - side.from);
  return length;
}

/// Returns the side that the ray from `from` along the unit vector `ahead` meets first, if it is
/// nearer than `within`; nullptr otherwise.
const Side* NextSide(const std::vector<Side>& sides, const Side* but, const Vector2& from,
                     const Vector2& ahead, double within) {
  const Side* next = nullptr;
  for (const Side& side : sides) {
    const Vector2 a = side.from - from, b = side.to - from;
    const double left = Cross(ahead, a), right = Cross(ahead, b);
    if ((left > 0) == (right > 0) || &side == but) continue;
    const double t = left / (left - right);
    const double distance = Dot(ahead, a) + t * Dot(ahead, b - a);
    if (distance <= 0 || distance >= within) continue;
    within = distance;
    next = &side;
  }
  return next;
}

}  // namespace

bool SeesFacingSides(const PolygonWithHoles& island, Coord within_nm, double least_turn,
                     int looks) {
  const std::vector<Side> sides = SidesOf(island);
  const double facing = Cos(least_turn), step = Length(sides) / looks;
  double ahead = step / 2;  // distance to the next place
  for (const Side& side : sides) {
    const Vector2 along = side.to - side.from;
    const double length = Norm(along);
    for (; ahead < length; ahead += step) {
      const Side* next = NextSide(sides, &side, side.from + ahead / length * along,
                                  TurnedLeft(along) / length, static_cast<double>(within_nm));
      if (next == nullptr) continue;
      const Vector2 opposite = next->to - next->from;
      if (Dot(along, opposite) < facing * length * Norm(opposite)) return true;
    }
    ahead -= length;
  }
  return false;
}

}  // namespace slicefarm::beading
