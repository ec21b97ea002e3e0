#include "services/slicing/algo/placement/arranging/footprint.h"

#include <algorithm>
#include <array>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"

namespace slicefarm::slicing {
namespace {

using Octagon = std::array<Point, 8>;

/// Returns the farthest vertices in eight directions. Vertices inside this octagon are no corners
/// of the hull, and most vertices are inside. Source: Akl and Toussaint 1978.
Octagon ExtremePoints(std::span<const IndexedMesh* const> meshes) {
  constexpr std::array<Point, 8> kDirections = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  Octagon points;
  points.fill({INT64_MAX, INT64_MAX});
  std::array<Coord, 8> farthest;
  farthest.fill(INT64_MIN);
  for (const IndexedMesh* mesh : meshes) {
    for (const Vertex& v : mesh->vertices) {
      for (size_t i = 0; i < kDirections.size(); ++i) {
        const Coord reach = kDirections[i].x * v.x + kDirections[i].y * v.y;
        if (reach <= farthest[i]) continue;
        farthest[i] = reach;
        points[i] = {v.x, v.y};
      }
    }
  }
  return points;
}

struct Copy {
  CopyOf which;
  Point center;
  Box box;
};

std::vector<Copy> AllCopies(std::span<const Copies> parts) {
  std::vector<Copy> copies;
  for (size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].footprint->size() < 3) continue;
    const Box box = Bounds(*parts[part].footprint);
    for (size_t copy = 0; copy < parts[part].centers.size(); ++copy) {
      const Point center = parts[part].centers[copy];
      copies.push_back({{part, copy}, center, {box.min + center, box.max + center}});
    }
  }
  std::sort(copies.begin(), copies.end(),
            [](const Copy& a, const Copy& b) { return a.box.min < b.box.min; });
  return copies;
}

bool Overlap(const Copy& a, const Copy& b, std::span<const Copies> parts) {
  if (a.box.max.y <= b.box.min.y || b.box.max.y <= a.box.min.y) return false;
  const MultiPolygon common = Intersection({{Moved(*parts[a.which.part].footprint, a.center), {}}},
                                           {{Moved(*parts[b.which.part].footprint, b.center), {}}});
  return Area(common) > 0;
}

}  // namespace

Polygon Footprint(std::span<const IndexedMesh* const> meshes) {
  const Octagon inner = ExtremePoints(meshes);
  std::vector<Point> points(inner.begin(), inner.end());
  const Polygon core = ConvexHull(points);
  for (const IndexedMesh* mesh : meshes) {
    for (const Vertex& v : mesh->vertices) {
      const Point p{v.x, v.y};
      if (core.size() < 3 || Locate(p, core) == Side::kOutside) points.push_back(p);
    }
  }
  return points.front() == Point{INT64_MAX, INT64_MAX} ? Polygon{} : ConvexHull(std::move(points));
}

std::vector<std::pair<CopyOf, CopyOf>> OverlappingFootprints(std::span<const Copies> parts) {
  const std::vector<Copy> copies = AllCopies(parts);
  std::vector<std::pair<CopyOf, CopyOf>> pairs;
  for (size_t i = 0; i < copies.size(); ++i) {
    for (size_t j = i + 1; j < copies.size() && copies[j].box.min.x < copies[i].box.max.x; ++j)
      if (Overlap(copies[i], copies[j], parts))
        pairs.push_back(std::minmax(copies[i].which, copies[j].which));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace slicefarm::slicing
