#include "services/slicing/algo/holes/polyholes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"

namespace slicefarm::slicing {
namespace {

constexpr size_t kLeastCorners = 9;
/// Number of consecutive layers with different twisted polygons.
constexpr int32_t kTwists = 5;

/// Smallest and largest of some numbers.
struct Spread {
  double least = 1e300, most = 0;
  void Add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  double Width() const { return most - least; }
};

/// Returns true if a clockwise ring turns in one direction only.
bool IsConvexHole(const Polygon& hole) {
  const size_t count = hole.size();
  for (size_t i = 0; i < count; ++i) {
    const Point a = hole[i], b = hole[(i + 1) % count], c = hole[(i + 2) % count];
    if (Cross(b - a, c - b) > 0) return false;
  }
  return true;
}

double ThresholdOf(const PolyholeOptions& options, double radius_nm) {
  return std::max(1.0,
                  static_cast<double>(options.threshold_nm) + options.threshold_share * radius_nm);
}

/// Round hole of one layer.
struct FoundHole {
  Polygon ring;
  HoleCircle circle;
};

std::vector<FoundHole> HolesOf(const ObjectSection& section, const PolyholeOptions& options) {
  std::vector<FoundHole> found;
  if (section.hollow) return found;
  for (const PolygonWithHoles& island : OutlineOf(section))
    for (const Polygon& hole : island.holes)
      if (const auto circle = CircleOf(hole, options)) found.push_back({hole, *circle});
  return found;
}

bool AreSame(const HoleCircle& a, const HoleCircle& b, const PolyholeOptions& options) {
  const double threshold = ThresholdOf(options, a.radius_nm);
  return Distance(a.center, b.center) < threshold &&
         std::abs(a.radius_nm - b.radius_nm) < threshold;
}

/// Takes the circle of the hole below, so that all layers of a hole have the same circle. Returns
/// for each hole of `here` whether it continues the hole of the layer below.
std::vector<char> Continued(const std::vector<FoundHole>& below, std::vector<FoundHole>& here,
                            const PolyholeOptions& options) {
  std::vector<char> continued(here.size(), 0);
  for (size_t i = 0; i < here.size(); ++i)
    for (const FoundHole& other : below) {
      if (!AreSame(other.circle, here[i].circle, options)) continue;
      here[i].circle = other.circle;
      continued[i] = 1;
      break;
    }
  return continued;
}

bool Touches(const Region& region, const Polygon& hole) {
  return std::ranges::any_of(region.outlines, [&](const PolygonWithHoles& island) {
    return std::ranges::count(island.holes, hole) > 0;
  });
}

/// Replaces a hole by a polygon that is as large or larger.
void ReplaceHole(const Polygon& hole, const Polygon& polyhole, ObjectSection& section) {
  Polygon outer(polyhole.rbegin(), polyhole.rend());
  Polygon filling(hole.rbegin(), hole.rend());
  for (Region& region : section.regions) {
    // Corners of the circle may be outside the polygon's edges.
    if (Touches(region, hole))
      region.outlines = Union(region.outlines, MultiPolygon{{filling, {}}});
    region.outlines = Difference(region.outlines, MultiPolygon{{outer, {}}});
  }
  std::erase_if(section.regions, [](const Region& region) { return region.outlines.empty(); });
  if (section.regions.size() > 1) {
    section.whole =
        Difference(Union(section.whole, MultiPolygon{{filling, {}}}), MultiPolygon{{outer, {}}});
  } else {
    section.whole.clear();
  }
}

}  // namespace

std::optional<HoleCircle> CircleOf(const Polygon& hole, const PolyholeOptions& options) {
  if (hole.size() < kLeastCorners || !IsConvexHole(hole)) return std::nullopt;
  const Point center = Centroid(hole);
  Spread corners, middles;
  double sum = 0;
  for (size_t i = 0; i < hole.size(); ++i) {
    const Point a = hole[i], b = hole[(i + 1) % hole.size()];
    const double distance = Distance(a, center);
    sum += distance;
    corners.Add(distance);
    middles.Add(Distance({(a.x + b.x) / 2, (a.y + b.y) / 2}, center));
  }
  const double threshold = ThresholdOf(options, sum / static_cast<double>(hole.size()));
  if (corners.Width() >= 2 * threshold || middles.Width() >= 2 * threshold) return std::nullopt;
  return HoleCircle{center, corners.most};
}

Polygon Polyhole(const HoleCircle& circle, const PolyholeOptions& options, int32_t layer) {
  constexpr double kEdgesPerMm = 4, kUsualNozzleMm = 0.4;
  const double nozzles = ToMm(circle.radius_nm) * kUsualNozzleMm / ToMm(options.nozzle_nm);
  int32_t edges = std::max(3, static_cast<int32_t>(std::lround(kEdgesPerMm * nozzles)));
  if (options.max_edges > 0) edges = std::min(edges, std::max(3, options.max_edges));
  const double edge_rad = 2 * std::numbers::pi / edges;
  const double turn = options.twisted ? layer % kTwists * edge_rad / kTwists : 0;
  const double radius = circle.radius_nm / Cos(edge_rad / 2);
  Polygon hole;
  for (int32_t i = 0; i < edges; ++i) {
    const double angle = turn - i * edge_rad;  // clockwise, as holes are
    hole.push_back({circle.center.x + std::llround(radius * Cos(angle)),
                    circle.center.y + std::llround(radius * Sin(angle))});
  }
  return hole;
}

void MakePolyholes(const PolyholeOptions& options, std::span<ObjectSection* const> sections,
                   const CancelToken& cancel) {
  if (!options.on || sections.empty()) return;
  std::vector<std::vector<FoundHole>> found;
  for (const ObjectSection* section : sections) {
    if (cancel.Cancelled()) return;
    found.push_back(HolesOf(*section, options));
  }
  std::vector<std::vector<char>> replaced(sections.size());
  for (size_t layer = 0; layer < sections.size(); ++layer)
    replaced[layer].assign(found[layer].size(), layer == 0 ? 1 : 0);
  for (size_t layer = 1; layer < sections.size(); ++layer) {
    const auto continued = Continued(found[layer - 1], found[layer], options);
    for (size_t i = 0; i < continued.size(); ++i)
      if (continued[i] != 0) replaced[layer][i] = 1;
    // The hole below is as high as two layers now.
    for (size_t j = 0; j < found[layer - 1].size(); ++j)
      for (size_t i = 0; i < continued.size(); ++i)
        if (continued[i] != 0 &&
            AreSame(found[layer - 1][j].circle, found[layer][i].circle, options))
          replaced[layer - 1][j] = 1;
  }
  for (size_t layer = 0; layer < sections.size() && !cancel.Cancelled(); ++layer)
    for (size_t i = 0; i < found[layer].size(); ++i)
      if (replaced[layer][i] != 0)
        ReplaceHole(found[layer][i].ring,
                    Polyhole(found[layer][i].circle, options, static_cast<int32_t>(layer)),
                    *sections[layer]);
}

}  // namespace slicefarm::slicing
