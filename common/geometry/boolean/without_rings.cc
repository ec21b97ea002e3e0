#include "common/geometry/boolean/without_rings.h"

#include <utility>
#include <vector>

#include "common/geometry/boolean/clipper_convert.h"

namespace slicefarm {
namespace {

/// Returns one bit for each side of the box that p is beyond.
int SidesBeyond(Point p, const Box& box) {
  return (p.x < box.min.x ? 1 : 0) | (p.x > box.max.x ? 2 : 0) | (p.y < box.min.y ? 4 : 0) |
         (p.y > box.max.y ? 8 : 0);
}

/// Returns the ring without points that cannot affect the box. A sequence of points that are all
/// beyond the same side of the box is replaced by its ends.
Polygon WithoutFarStretches(const Polygon& ring, const Box& box) {
  Polygon near;
  int common = 0;  // sides that all points since the last necessary one are beyond
  for (const Point p : ring) {
    const int sides = SidesBeyond(p, box);
    const bool goes_on = near.size() > 1 && (common & sides) != 0;
    if (goes_on) {
      common &= sides;
      near.back() = p;
      continue;
    }
    common = near.empty() ? 0 : SidesBeyond(near.back(), box) & sides;
    near.push_back(p);
  }
  return near;
}

}  // namespace

MultiPolygon WithoutRings(std::span<const Polygon> subject, std::span<const Polygon> rings) {
  if (subject.empty()) return {};
  ClipperLib::Clipper clipper;
  for (const Polygon& ring : subject)
    clipper.AddPath(internal::ToPath(ring), ClipperLib::ptSubject, true);
  for (const Polygon& ring : rings)
    clipper.AddPath(internal::ToPath(ring), ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return internal::FromTree(tree);
}

MultiPolygon WithoutRings(const MultiPolygon& region, std::span<const Polygon> rings) {
  return WithoutRings(Rings(region), rings);
}

void AppendRingsNear(const MultiPolygon& region, const Box& box, std::vector<Polygon>& rings) {
  for (const PolygonWithHoles& island : region) {
    if (!Bounds(island.outer).Intersects(box)) continue;
    rings.push_back(WithoutFarStretches(island.outer, box));
    for (const Polygon& hole : island.holes)
      if (Bounds(hole).Intersects(box)) rings.push_back(WithoutFarStretches(hole, box));
  }
}

}  // namespace slicefarm
