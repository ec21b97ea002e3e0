#include "services/planning/algo/supports/generator/bridge_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/vector.h"

namespace slicefarm::planning {
namespace {

/// Distance beyond an edge, or beyond the end of a wall, at which the layer below is tested.
constexpr double kBesideNm = 100'000;
/// Largest distance of a straight wall from its chord.
constexpr double kBendNm = 100'000;

Point ToPoint(const Vector2& v) { return {std::llround(v.x()), std::llround(v.y())}; }

/// Returns true if nothing of the layer below is beside the edge's outer side. The part is to the
/// left of every edge.
bool IsFree(Point a, Point b, const MultiPolygon& below) {
  const Vector2 along = (ToVector(b) - ToVector(a)).normalized();
  return !Covers(below, ToPoint((ToVector(a) + ToVector(b)) / 2 - kBesideNm * TurnedLeft(along)));
}

/// Returns the chains of a ring's free edges. If all edges are free, the chain passes its first
/// corner twice.
std::vector<Polyline> FreeEdges(const Polygon& ring, const MultiPolygon& below) {
  const size_t size = ring.size();
  std::vector<bool> free(size);
  for (size_t i = 0; i < size; ++i) free[i] = IsFree(ring[i], ring[(i + 1) % size], below);
  const auto held = static_cast<size_t>(std::ranges::find(free, false) - free.begin());
  const size_t first = held == size ? 0 : held;
  std::vector<Polyline> chains;
  bool goes_on = false;
  for (size_t k = 0; k < size; ++k) {
    const size_t i = (first + k) % size;
    if (free[i]) {
      if (!goes_on) chains.push_back({ring[i]});
      chains.back().push_back(ring[(i + 1) % size]);
    }
    goes_on = free[i];
  }
  if (held == size) chains.front().push_back(ring[1]);
  return chains;
}

bool IsStraight(const Polyline& chain) {
  return std::ranges::all_of(
      chain, [&](Point p) { return DistanceToSegment(p, chain.front(), chain.back()) <= kBendNm; });
}

/// Returns true if the chain is straight and the layer below supports both of its ends. At corners
/// within a chain the wall has no support.
bool IsHeld(const Polyline& chain, const MultiPolygon& below) {
  if (!IsStraight(chain)) return false;
  const Vector2 from = ToVector(chain.front()), to = ToVector(chain.back());
  const Vector2 ahead = kBesideNm * (to - from).normalized();
  const Vector2 aside = TurnedLeft(ahead);
  return Covers(below, ToPoint(from - ahead + aside)) && Covers(below, ToPoint(to + ahead + aside));
}

MultiPolygon Along(const std::vector<Polyline>& chains, Coord walls_nm,
                   const PolygonWithHoles& part) {
  if (chains.empty()) return {};
  return Intersection(OffsetLines(chains, walls_nm, Cap::kButt), {part});
}

}  // namespace

BridgeWalls WallsOf(const PolygonWithHoles& part, const MultiPolygon& below, Coord walls_nm) {
  if (walls_nm == 0) return {};
  std::vector<Polyline> all, held;
  ForEachRing({part}, [&](const Polygon& ring) {
    for (Polyline& chain : FreeEdges(ring, below)) {
      if (IsHeld(chain, below)) held.push_back(chain);
      all.push_back(std::move(chain));
    }
  });
  return {Along(all, walls_nm, part), Along(held, walls_nm, part)};
}

}  // namespace slicefarm::planning
