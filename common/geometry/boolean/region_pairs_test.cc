#include "common/geometry/boolean/region_pairs_test.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/rings/simple_rings.h"

namespace slicefarm {
namespace {

using Pick = std::function<uint32_t(uint32_t)>;

constexpr Coord kStepNm = 1'000'000;

double Unit(const Pick& pick) { return pick(1001) / 1000.0; }

/// Returns the point at `radius` mm from (x, y) mm in the given direction.
Point Polar(double x, double y, double radius, double angle_rad) {
  return {FromMm(x + radius * Cos(angle_rad)), FromMm(y + radius * Sin(angle_rad))};
}

/// Returns a ring with waves or teeth, and often a hole of the same shape.
MultiPolygon Wavy(const Pick& pick) {
  const uint32_t points = 3 + pick(60), waves = pick(9);
  const double x = pick(9), y = pick(9), depth = 0.4 * Unit(pick), noise = pick(2) * 0.4;
  const bool has_hole = pick(3) != 0;
  PolygonWithHoles island;
  Polygon hole;
  for (uint32_t i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    const double r = 6 * (1 + depth * Sin(waves * t) - noise * Unit(pick));
    island.outer.push_back(Polar(x, y, r, t));
    hole.push_back(Polar(x, y, r * 0.4, t));
  }
  std::reverse(hole.begin(), hole.end());
  if (has_hole) island.holes.push_back(hole);
  return {island};
}

/// Returns columns of whole millimetres side by side: upright, horizontal, hanging or leaning.
MultiPolygon Skyline(const Pick& pick) {
  Polygon ring;
  const Coord left = pick(6), base = pick(4);
  const uint32_t columns = 1 + pick(6), turn = pick(4);
  Coord x = left;
  ring.push_back({x, base});
  Polygon tops;
  for (uint32_t i = 0; i < columns; ++i) {
    const Coord height = base + 1 + pick(6);
    tops.push_back({x, height});
    x += 1 + pick(2);
    tops.push_back({x, height});
  }
  ring.push_back({x, base});
  for (auto top = tops.rbegin(); top != tops.rend(); ++top)
    if (ring.back() != *top) ring.push_back(*top);
  for (Point& p : ring) {
    if (turn == 1) p = {p.y, p.x};
    if (turn == 2) p = {p.x, 10 - p.y};
    if (turn == 3) p = {p.x + p.y, p.y};
    p = {p.x * kStepNm, p.y * kStepNm};
  }
  if (SignedArea(ring) < 0) std::reverse(ring.begin(), ring.end());
  return {{ring, {}}};
}

Polygon Square(Point middle, Coord half) {
  const auto [x, y] = middle;
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

/// Returns frames in the holes of frames.
MultiPolygon Nested(const Pick& pick) {
  MultiPolygon frames;
  const Point middle = {static_cast<Coord>(pick(4)) * kStepNm,
                        static_cast<Coord>(pick(4)) * kStepNm};
  Coord half = (4 + static_cast<Coord>(pick(8))) * kStepNm;
  while (half > kStepNm) {
    PolygonWithHoles frame{Square(middle, half), {}};
    half -= kStepNm;
    if (pick(4) != 0) {
      frame.holes.push_back(Square(middle, half));
      std::reverse(frame.holes[0].begin(), frame.holes[0].end());
      half -= kStepNm * static_cast<Coord>(1 + pick(2));
    }
    const bool is_full = frame.holes.empty();
    frames.push_back(std::move(frame));
    if (is_full) break;
  }
  return frames;
}

/// Returns a triangle of up to 100 mm that is some nanometres or micrometres wide.
MultiPolygon Sliver(const Pick& pick) {
  constexpr std::array<Coord, 6> kWidths = {1, 2, 7, 100, 3'000, 200'000};
  const auto place = [&](uint32_t size) {
    return static_cast<Coord>(pick(size)) * kStepNm + pick(3);
  };
  const Point a = {place(8), place(8)}, b = {place(100), place(10)};
  const Coord width = kWidths[pick(kWidths.size())];
  Polygon ring = {a, b, pick(2) == 0 ? Point{b.x, b.y + width} : Point{b.x + width, b.y}};
  if (SignedArea(ring) < 0) std::swap(ring[1], ring[2]);
  return {{ring, {}}};
}

MultiPolygon Any(const Pick& pick) {
  switch (pick(4)) {
    case 0:
      return Wavy(pick);
    case 1:
      return Skyline(pick);
    case 2:
      return Nested(pick);
    default:
      return Sliver(pick);
  }
}

template <typename Change>
MultiPolygon Changed(MultiPolygon region, const Change& change) {
  for (PolygonWithHoles& island : region) {
    for (Point& p : island.outer) p = change(p);
    for (Polygon& hole : island.holes)
      for (Point& p : hole) p = change(p);
  }
  return region;
}

/// Moves some points by a few nanometres.
MultiPolygon Jittered(const MultiPolygon& region, const Pick& pick) {
  const uint32_t share = 1 + pick(4);
  return Changed(region, [&](Point p) {
    if (pick(share) != 0) return p;
    return Point{p.x + pick(5) - 2, p.y + pick(5) - 2};
  });
}

MultiPolygon Turned(const MultiPolygon& region, const Pick& pick) {
  constexpr std::array kAngles = {1e-9, 1e-7, 1e-6, 1e-4};
  const double angle = kAngles[pick(kAngles.size())], c = Cos(angle), s = Sin(angle);
  return Changed(region, [&](Point p) {
    const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
    return Point{std::llround(c * x - s * y), std::llround(s * x + c * y)};
  });
}

/// Returns true if the region meets the requirements of booleans and offsets.
bool IsSimple(const MultiPolygon& region) {
  std::vector<const Polygon*> rings;
  bool has_area = true;
  for (const PolygonWithHoles& island : region) {
    has_area &= SignedArea(island.outer) > 0;
    rings.push_back(&island.outer);
    for (const Polygon& hole : island.holes) {
      has_area &= SignedArea(hole) < 0;
      rings.push_back(&hole);
    }
  }
  return has_area && AreSimple(rings);
}

RegionPair Make(const Pick& pick) {
  const uint32_t kind = pick(8);
  if (kind == 0) return {"waves", Wavy(pick), Wavy(pick)};
  if (kind == 1) return {"columns", Skyline(pick), Skyline(pick)};
  if (kind == 2) return {"nested", Nested(pick), Nested(pick)};
  if (kind == 3) return {"slivers", Sliver(pick), Sliver(pick)};
  MultiPolygon a = Any(pick);
  if (kind == 4) return {"jittered", a, Jittered(a, pick)};
  if (kind == 5) {
    const Point by = {static_cast<Coord>(pick(5)), static_cast<Coord>(pick(3))};
    return {"moved", a, Moved(a, by)};
  }
  if (kind == 6) return {"turned", a, Turned(a, pick)};
  return {"mixed", a, Any(pick)};
}

}  // namespace

RegionPair MakeRegionPair(const Pick& pick) {
  RegionPair pair = Make(pick);
  for (MultiPolygon* region : {&pair.a, &pair.b})
    if (!IsSimple(*region)) *region = Skyline(pick);
  return pair;
}

}  // namespace slicefarm
