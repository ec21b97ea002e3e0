#include "common/geometry/boolean/clipper_convert.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"

namespace slicefarm::internal {
namespace {

void AppendIslands(const ClipperLib::PolyNode& parent, MultiPolygon& out) {
  for (const ClipperLib::PolyNode* outer : parent.Childs) {
    PolygonWithHoles island;
    island.outer = FromPath(outer->Contour);
    island.holes.reserve(outer->Childs.size());
    for (const ClipperLib::PolyNode* hole : outer->Childs)
      island.holes.push_back(FromPath(hole->Contour));
    out.push_back(std::move(island));
    for (const ClipperLib::PolyNode* hole : outer->Childs) AppendIslands(*hole, out);
  }
}

/// Returns true if the rings of an island have the direction that the tree implies, and its holes
/// can be inside it.
bool IsPlausible(const PolygonWithHoles& island) {
  if (SignedArea(island.outer) < 0) return false;
  const Box box = Bounds(island.outer);
  return std::ranges::all_of(island.holes, [&](const Polygon& hole) {
    const Box inner = Bounds(hole);
    return SignedArea(hole) <= 0 && inner.min.x >= box.min.x && inner.min.y >= box.min.y &&
           inner.max.x <= box.max.x && inner.max.y <= box.max.y;
  });
}

/// Returns true if most corners of `ring` are inside `outer`. Corners on the boundary of `outer` do
/// not count.
bool LiesIn(const Polygon& ring, const Polygon& outer) {
  int64_t inside = 0;
  for (const Point corner : ring) {
    const Side side = Locate(corner, outer);
    inside += side == Side::kInside ? 1 : side == Side::kOutside ? -1 : 0;
  }
  return inside > 0;
}

/// Returns the innermost island around a hole; null if there is none.
PolygonWithHoles* IslandAround(const Polygon& hole, MultiPolygon& islands) {
  PolygonWithHoles* around = nullptr;
  double least = 0;
  for (PolygonWithHoles& island : islands) {
    const double area = SignedArea(island.outer);
    if ((around != nullptr && area >= least) || !Bounds(island.outer).Intersects(Bounds(hole)) ||
        !LiesIn(hole, island.outer))
      continue;
    around = &island;
    least = area;
  }
  return around;
}

void AppendRings(const ClipperLib::PolyNode& parent, std::vector<Polygon>& rings) {
  for (const ClipperLib::PolyNode* ring : parent.Childs) {
    rings.push_back(FromPath(ring->Contour));
    AppendRings(*ring, rings);
  }
}

}  // namespace

MultiPolygon FromRings(std::vector<Polygon> rings) {
  MultiPolygon islands;
  const auto holes = std::stable_partition(
      rings.begin(), rings.end(), [](const Polygon& ring) { return SignedArea(ring) > 0; });
  for (auto ring = rings.begin(); ring != holes; ++ring) islands.push_back({std::move(*ring), {}});
  for (auto hole = holes; hole != rings.end(); ++hole)
    if (PolygonWithHoles* around = IslandAround(*hole, islands); around != nullptr)
      around->holes.push_back(std::move(*hole));
  Canonicalize(islands);
  return islands;
}

ClipperLib::Path ToPath(const std::vector<Point>& points) {
  ClipperLib::Path path;
  path.reserve(points.size());
  for (const Point p : points) path.emplace_back(p.x, p.y);
  return path;
}

std::vector<Point> FromPath(const ClipperLib::Path& path) {
  std::vector<Point> points;
  points.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path) points.push_back({p.X, p.Y});
  return points;
}

void AppendRings(const MultiPolygon& polygons, ClipperLib::Paths& paths) {
  ForEachRing(polygons, [&](const Polygon& ring) { paths.push_back(ToPath(ring)); });
}

MultiPolygon FromTree(const ClipperLib::PolyNode& root) {
  MultiPolygon polygons;
  AppendIslands(root, polygons);
  if (!std::ranges::all_of(polygons, IsPlausible)) {
    std::vector<Polygon> rings;
    AppendRings(root, rings);
    return FromRings(std::move(rings));
  }
  Canonicalize(polygons);
  return polygons;
}

}  // namespace slicefarm::internal
