#include "common/geometry/boolean.h"

#include <algorithm>

#include "common/geometry/clipper_convert.h"
#include "common/geometry/measure.h"

namespace slicefarm {
namespace {

using ClipperLib::Paths;

ClipperLib::PolyFillType ToClipper(FillRule rule) {
  switch (rule) {
    case FillRule::kNonZero:
      return ClipperLib::pftNonZero;
    case FillRule::kEvenOdd:
      return ClipperLib::pftEvenOdd;
    case FillRule::kPositive:
      return ClipperLib::pftPositive;
  }
  return ClipperLib::pftNonZero;
}

MultiPolygon Execute(ClipperLib::ClipType type, const Paths& subject, const Paths& clip,
                     ClipperLib::PolyFillType subject_fill, ClipperLib::PolyFillType clip_fill) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(type, tree, subject_fill, clip_fill);
  return internal::FromTree(tree);
}

MultiPolygon Execute(ClipperLib::ClipType type, const MultiPolygon& a, const MultiPolygon& b) {
  Paths subject, clip;
  internal::AppendRings(a, subject);
  internal::AppendRings(b, clip);
  return Execute(type, subject, clip, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
}

/// Rings whose winding number is positive exactly where at least `count` of the regions lie: all of
/// them, less one around everything for each region that may be missing.
Paths CountingRings(std::span<const MultiPolygon* const> regions, int count) {
  Paths paths;
  Box box;
  for (const MultiPolygon* region : regions) {
    internal::AppendRings(*region, paths);
    box.Add(Bounds(*region));
  }
  if (box.Empty()) return {};
  box = box.Grown(kNmPerMm);
  const Polygon clockwise = {box.min, {box.min.x, box.max.y}, box.max, {box.max.x, box.min.y}};
  for (int i = 1; i < count; ++i) paths.push_back(internal::ToPath(clockwise));
  return paths;
}

}  // namespace

MultiPolygon Union(std::span<const Polygon> rings, FillRule rule) {
  Paths paths;
  paths.reserve(rings.size());
  for (const Polygon& ring : rings) paths.push_back(internal::ToPath(ring));
  return Execute(ClipperLib::ctUnion, paths, {}, ToClipper(rule), ToClipper(rule));
}

MultiPolygon Union(const MultiPolygon& a, const MultiPolygon& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return Execute(ClipperLib::ctUnion, a, b);
}

MultiPolygon Difference(const MultiPolygon& a, const MultiPolygon& b) {
  if (!Bounds(a).Intersects(Bounds(b))) return a;
  return Execute(ClipperLib::ctDifference, a, b);
}

MultiPolygon Intersection(const MultiPolygon& a, const MultiPolygon& b) {
  if (!Bounds(a).Intersects(Bounds(b))) return {};
  return Execute(ClipperLib::ctIntersection, a, b);
}

MultiPolygon CoveredAtLeast(std::span<const MultiPolygon* const> regions, int count) {
  if (count > static_cast<int>(regions.size())) return {};
  return Execute(ClipperLib::ctUnion, CountingRings(regions, count), {}, ClipperLib::pftPositive,
                 ClipperLib::pftPositive);
}

MultiPolygon DifferenceCovered(const MultiPolygon& subject,
                               std::span<const MultiPolygon* const> regions, int count) {
  if (subject.empty() || count > static_cast<int>(regions.size())) return subject;
  Paths paths;
  internal::AppendRings(subject, paths);
  return Execute(ClipperLib::ctDifference, paths, CountingRings(regions, count),
                 ClipperLib::pftNonZero, ClipperLib::pftPositive);
}

std::vector<Polyline> ClipLines(std::span<const Polyline> lines, const MultiPolygon& clip) {
  if (lines.empty() || clip.empty()) return {};
  ClipperLib::Clipper clipper;
  for (const Polyline& line : lines)
    clipper.AddPath(internal::ToPath(line), ClipperLib::ptSubject, false);
  Paths clip_paths;
  internal::AppendRings(clip, clip_paths);
  clipper.AddPaths(clip_paths, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  Paths open;
  ClipperLib::OpenPathsFromPolyTree(tree, open);
  std::vector<Polyline> parts;
  parts.reserve(open.size());
  for (const ClipperLib::Path& path : open) parts.push_back(internal::FromPath(path));
  return parts;
}

}  // namespace slicefarm
