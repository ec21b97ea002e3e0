#include "services/slicing/algo/placement/footprint.h"

#include <algorithm>
#include <utility>

#include "common/geometry/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"

namespace slicefarm::slicing {
namespace {

struct Copy {
  size_t part = 0;
  Point center;
  Box box;
  bool overlaps = false;
};

std::vector<Copy> AllCopies(std::span<const Copies> parts) {
  std::vector<Copy> copies;
  for (size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].footprint->size() < 3) continue;
    const Box box = Bounds(*parts[part].footprint);
    for (const Point center : parts[part].centers)
      copies.push_back({part, center, {box.min + center, box.max + center}});
  }
  std::sort(copies.begin(), copies.end(),
            [](const Copy& a, const Copy& b) { return a.box.min < b.box.min; });
  return copies;
}

bool Overlap(const Copy& a, const Copy& b, std::span<const Copies> parts) {
  if (a.box.max.y <= b.box.min.y || b.box.max.y <= a.box.min.y) return false;
  const MultiPolygon common = Intersection({{Moved(*parts[a.part].footprint, a.center), {}}},
                                           {{Moved(*parts[b.part].footprint, b.center), {}}});
  return Area(common) > 0;
}

}  // namespace

Polygon Footprint(const IndexedMesh& mesh) {
  std::vector<Point> points;
  points.reserve(mesh.vertices.size());
  for (const Vertex& v : mesh.vertices) points.push_back({v.x, v.y});
  return ConvexHull(std::move(points));
}

std::vector<int64_t> CountOverlapping(std::span<const Copies> parts) {
  std::vector<Copy> copies = AllCopies(parts);
  for (size_t i = 0; i < copies.size(); ++i) {
    for (size_t j = i + 1; j < copies.size() && copies[j].box.min.x < copies[i].box.max.x; ++j) {
      if (copies[i].overlaps && copies[j].overlaps) continue;
      if (Overlap(copies[i], copies[j], parts)) copies[i].overlaps = copies[j].overlaps = true;
    }
  }
  std::vector<int64_t> counts(parts.size(), 0);
  for (const Copy& copy : copies) counts[copy.part] += copy.overlaps;
  return counts;
}

}  // namespace slicefarm::slicing
