#include "services/planning/algo/supports/generator/bridges.h"

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
#include "common/geometry/vector.h"
#include "services/planning/algo/supports/generator/bridge_walls.h"

namespace slicefarm::planning {
namespace {

constexpr int kDirections = 36;
/// Distance beyond a line's end that the layer below must cover, so that the end is anchored.
constexpr Coord kProbeNm = 100'000;
/// Smallest share of an overhang that a bridge must cover. Smaller scraps between supports save
/// nothing.
constexpr double kLeastShare = 0.2;

/// Rotates p so that lines along the unit vector `path` become parallel to x.
Point TurnedToX(Point p, const Vector2& path) {
  return {std::llround(p.x * path.x() + p.y * path.y()),
          std::llround(p.y * path.x() - p.x * path.y())};
}

/// Reverses TurnedToX.
Point TurnedBack(Point p, const Vector2& path) {
  return {std::llround(p.x * path.x() - p.y * path.y()),
          std::llround(p.x * path.y() + p.y * path.x())};
}

struct Span {
  Coord from = 0;
  Coord to = 0;
  Coord y = 0;
};

/// Horizontal lines at even distances.
struct Lines {
  Coord first_nm = 0;
  Coord pitch_nm = 1;
  Coord count = 0;

  Coord At(Coord i) const { return first_nm + i * pitch_nm; }
};

/// Returns the x positions where each line crosses the rings, in order.
std::vector<std::vector<Coord>> Crossings(std::span<const Polygon> rings, const Lines& lines) {
  std::vector<std::vector<Coord>> xs(static_cast<size_t>(lines.count));
  for (const Polygon& ring : rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (a.y > b.y) std::swap(a, b);
      const Coord from = std::max<Coord>(0, (a.y - lines.first_nm) / lines.pitch_nm);
      for (Coord line = from; line < lines.count && lines.At(line) < b.y; ++line) {
        const Coord y = lines.At(line);
        if (y < a.y) continue;
        xs[static_cast<size_t>(line)].push_back(
            a.x + std::llround(static_cast<double>(b.x - a.x) * (y - a.y) / (b.y - a.y)));
      }
    }
  }
  for (auto& line : xs) std::sort(line.begin(), line.end());
  return xs;
}

bool Covers(const std::vector<Coord>& crossings, Coord x) {
  const auto before = std::lower_bound(crossings.begin(), crossings.end(), x) - crossings.begin();
  return before % 2 == 1;
}

std::vector<Polygon> Turned(const MultiPolygon& region, const Vector2& direction) {
  std::vector<Polygon> rings = Rings(region);
  for (Polygon& ring : rings)
    for (Point& p : ring) p = TurnedToX(p, direction);
  return rings;
}

/// Returns the pieces of lines in `part` with both ends on `below`.
std::vector<Span> AnchoredSpans(const MultiPolygon& part, const MultiPolygon& below,
                                const Vector2& direction, Coord width_nm) {
  if (part.empty()) return {};
  const std::vector<Polygon> rings = Turned(part, direction), anchors = Turned(below, direction);
  Box box;
  for (const Polygon& ring : rings) box.Add(Bounds(ring));
  const Coord high = box.max.y - box.min.y, count = std::max<Coord>(1, high / width_nm);
  const Lines lines = {box.min.y + high / (2 * count), std::max<Coord>(1, high / count), count};
  const auto inside = Crossings(rings, lines), held = Crossings(anchors, lines);
  std::vector<Span> spans;
  for (size_t i = 0; i < inside.size(); ++i)
    for (size_t k = 0; k + 1 < inside[i].size(); k += 2)
      if (Covers(held[i], inside[i][k] - kProbeNm) && Covers(held[i], inside[i][k + 1] + kProbeNm))
        spans.push_back({inside[i][k], inside[i][k + 1], lines.At(static_cast<Coord>(i))});
  return spans;
}

std::vector<Vector2> Candidates(const PolygonWithHoles& part, Coord width_nm) {
  std::vector<Vector2> directions;
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

/// Returns true if the part is on average no wider than two lines. Such a strip is no bridge.
bool IsNarrow(const PolygonWithHoles& part, Coord width_nm) {
  double edges = 0;
  ForEachRing({part}, [&](const Polygon& ring) { edges += Perimeter(ring); });
  return Area(part) < width_nm * edges;
}

/// Removes walls that are longer than the longest bridge. The length of a wall is half the length
/// of its edge.
void DropLong(Coord longest_nm, MultiPolygon& walls) {
  if (longest_nm <= 0) return;
  std::erase_if(walls, [&](const PolygonWithHoles& wall) {
    return Perimeter(wall.outer) / 2 > static_cast<double>(longest_nm);
  });
}

MultiPolygon Bridge(const PolygonWithHoles& part, const MultiPolygon& below,
                    const BridgeBeads& beads) {
  const Coord width_nm = beads.width_nm;
  BridgeWalls walls = WallsOf(part, below, beads.walls_nm);
  DropLong(beads.longest_nm, walls.held);
  const MultiPolygon lined = Difference({part}, walls.area);
  std::vector<Span> best;
  Vector2 along = Vector2::UnitX();
  double most = 0;
  for (const Vector2& direction : Candidates(part, width_nm)) {
    std::vector<Span> spans = AnchoredSpans(lined, below, direction, width_nm);
    std::erase_if(spans, [&](const Span& span) {
      return beads.longest_nm > 0 && span.to - span.from > beads.longest_nm;
    });
    const double covered = Covered(spans);
    if (covered <= most * 1.001) continue;
    most = covered;
    best = std::move(spans);
    along = direction;
  }
  if (most * width_nm + Area(walls.held) < kLeastShare * Area(part)) return {};
  std::vector<Polygon> strips;
  const Coord half = width_nm / 2 + width_nm / 10;
  for (const Span& s : best) {
    Polygon strip = {{s.from - kProbeNm, s.y - half},
                     {s.to + kProbeNm, s.y - half},
                     {s.to + kProbeNm, s.y + half},
                     {s.from - kProbeNm, s.y + half}};
    for (Point& p : strip) p = TurnedBack(p, along);
    strips.push_back(std::move(strip));
  }
  // The offset removes single lines, because at best they would be supported by their neighbours.
  for (Polygon& ring : Rings(walls.held)) strips.push_back(std::move(ring));
  return OffsetTwice(Union(strips, FillRule::kNonZero), -width_nm * 9 / 10, width_nm * 9 / 10);
}

}  // namespace

MultiPolygon BridgesOf(const MultiPolygon& hanging, const MultiPolygon& steep,
                       const MultiPolygon& below, const BridgeBeads& beads) {
  MultiPolygon bridges;
  for (const PolygonWithHoles& part : hanging) {
    const Box box = Bounds(part.outer);
    const bool looked_at = std::any_of(steep.begin(), steep.end(), [&](const auto& island) {
      return Bounds(island.outer).Intersects(box);
    });
    if (!looked_at || IsNarrow(part, beads.width_nm) || Intersection({part}, steep).empty())
      continue;
    std::vector<Polygon> rings;
    AppendRingsNear(below, box.Grown(1'000'000), rings);
    if (rings.empty()) continue;
    bridges = Union(bridges, Bridge(part, Union(rings, FillRule::kNonZero), beads));
  }
  return bridges;
}

}  // namespace slicefarm::planning
