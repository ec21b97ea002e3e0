#include "common/geometry/boolean/clipper_convert.h"

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

}  // namespace

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
  Canonicalize(polygons);
  return polygons;
}

}  // namespace slicefarm::internal
