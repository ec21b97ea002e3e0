#include "services/planning/algo/support/bridges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::planning {
namespace {

constexpr int kDirections = 36;
/// A line's end counts as anchored if the layer below is this far behind it.
constexpr Coord kProbeNm = 100'000;
/// The direction must carry this share of what is steep, or the part of the overhang is no bridge:
/// scraps between supports save nothing.
constexpr double kLeastShare = 0.2;

struct Direction {
  double x = 1;
  double y = 0;

  Point Turned(Point p) const {  // so that lines run along x
    return {std::llround(p.x * x + p.y * y), std::llround(p.y * x - p.x * y)};
  }
  Point Back(Point p) const {
    return {std::llround(p.x * x - p.y * y), std::llround(p.x * y + p.y * x)};
  }
};

struct Span {
  Coord from = 0;
  Coord to = 0;
  Coord y = 0;
};

/// Where a line at height y crosses the rings, in order.
std::vector<Coord> Crossings(std::span<const Polygon> rings, Coord y) {
  std::vector<Coord> xs;
  for (const Polygon& ring : rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      xs.push_back(a.x + std::llround(static_cast<double>(b.x - a.x) * (y - a.y) / (b.y - a.y)));
    }
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

bool Covers(const std::vector<Coord>& crossings, Coord x) {
  const auto before = std::lower_bound(crossings.begin(), crossings.end(), x) - crossings.begin();
  return before % 2 == 1;
}

std::vector<Polygon> Turned(const MultiPolygon& region, const Direction& direction) {
  std::vector<Polygon> rings = Rings(region);
  for (Polygon& ring : rings)
    for (Point& p : ring) p = direction.Turned(p);
  return rings;
}

/// Lines through `part` with both ends on `below`.
std::vector<Span> AnchoredSpans(const MultiPolygon& part, const MultiPolygon& below,
                                const Direction& direction, Coord width_nm) {
  const std::vector<Polygon> rings = Turned(part, direction), anchors = Turned(below, direction);
  Box box;
  for (const Polygon& ring : rings) box.Add(Bounds(ring));
  const Coord lines = std::max<Coord>(1, (box.max.y - box.min.y) / width_nm);
  std::vector<Span> spans;
  for (Coord i = 0; i < lines; ++i) {
    const Coord y = box.min.y + (box.max.y - box.min.y) * (2 * i + 1) / (2 * lines);
    const std::vector<Coord> inside = Crossings(rings, y), held = Crossings(anchors, y);
    for (size_t k = 0; k + 1 < inside.size(); k += 2)
      if (Covers(held, inside[k] - kProbeNm) && Covers(held, inside[k + 1] + kProbeNm))
        spans.push_back({inside[k], inside[k + 1], y});
  }
  return spans;
}

std::vector<Direction> Candidates(const PolygonWithHoles& part, Coord width_nm) {
  std::vector<Direction> directions;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = i * std::numbers::pi / kDirections;
    directions.push_back({Cos(angle), Sin(angle)});
  }
  const Polygon& ring = part.outer;
  for (size_t i = 0; i < ring.size() && ring.size() <= 64; ++i) {
    const Point edge = ring[(i + 1) % ring.size()] - ring[i];
    const double length = Norm(edge);
    if (length > 4.0 * width_nm) directions.push_back({edge.x / length, edge.y / length});
  }
  return directions;
}

double Covered(const std::vector<Span>& spans) {
  double sum = 0;
  for (const Span& span : spans) sum += span.to - span.from;
  return sum;
}

MultiPolygon Bridge(const PolygonWithHoles& part, const MultiPolygon& below, Coord width_nm) {
  std::vector<Span> best;
  Direction along;
  double most = 0;
  for (const Direction& direction : Candidates(part, width_nm)) {
    std::vector<Span> spans = AnchoredSpans({part}, below, direction, width_nm);
    const double covered = Covered(spans);
    if (covered <= most * 1.001) continue;
    most = covered;
    best = std::move(spans);
    along = direction;
  }
  if (most * width_nm < kLeastShare * Area(part)) return {};
  std::vector<Polygon> strips;
  const Coord half = width_nm / 2 + width_nm / 10;
  for (const Span& s : best) {
    Polygon strip = {{s.from - kProbeNm, s.y - half},
                     {s.to + kProbeNm, s.y - half},
                     {s.to + kProbeNm, s.y + half},
                     {s.from - kProbeNm, s.y + half}};
    for (Point& p : strip) p = along.Back(p);
    strips.push_back(std::move(strip));
  }
  // A single line is carried by its neighbours at best.
  return OffsetTwice(Union(strips, FillRule::kNonZero), -width_nm * 9 / 10, width_nm * 9 / 10);
}

}  // namespace

MultiPolygon BridgesOf(const MultiPolygon& hanging, const MultiPolygon& steep,
                       const MultiPolygon& below, Coord width_nm) {
  MultiPolygon bridges;
  for (const PolygonWithHoles& part : hanging) {
    const Box box = Bounds(part.outer);
    const bool looked_at = std::any_of(steep.begin(), steep.end(), [&](const auto& island) {
      return Bounds(island.outer).Intersects(box);
    });
    if (!looked_at || Intersection({part}, steep).empty()) continue;
    std::vector<Polygon> rings;
    AppendRingsNear(below, box.Grown(1'000'000), rings);
    if (rings.empty()) continue;
    bridges = Union(bridges, Bridge(part, Union(rings, FillRule::kNonZero), width_nm));
  }
  return bridges;
}

}  // namespace slicefarm::planning
