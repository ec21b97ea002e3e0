#include "common/geometry/offset/offset.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/boolean/by_island.h"
#include "common/geometry/boolean/clipper_convert.h"
#include "common/geometry/offset/offset_curve.h"

namespace slicefarm {
namespace {

using ClipperLib::ClipperOffset;

ClipperLib::JoinType ToClipper(Join join) {
  switch (join) {
    case Join::kMiter:
      return ClipperLib::jtMiter;
    case Join::kRound:
      return ClipperLib::jtRound;
    case Join::kSquare:
      return ClipperLib::jtSquare;
  }
  return ClipperLib::jtMiter;
}

ClipperLib::EndType ToClipper(Cap cap) {
  switch (cap) {
    case Cap::kButt:
      return ClipperLib::etOpenButt;
    case Cap::kSquare:
      return ClipperLib::etOpenSquare;
    case Cap::kRound:
      return ClipperLib::etOpenRound;
  }
  return ClipperLib::etOpenButt;
}

/// What `curves` wind around a positive number of times.
MultiPolygon Outside(const ClipperLib::Paths& curves) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(curves, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
  return internal::FromTree(tree);
}

/// Nothing else has a corner where the frame has its own.
bool IsFrame(const ClipperLib::Path& ring, const ClipperLib::Path& frame) {
  return std::find(ring.begin(), ring.end(), frame[0]) != ring.end();
}

/// The same, as the holes of its complement in a frame: Clipper is the more robust there for curves
/// of rings that shrink (as ClipperOffset does it).
MultiPolygon Inside(const ClipperLib::Paths& curves) {
  constexpr ClipperLib::cInt kMargin = 10;
  ClipperLib::Clipper clipper;
  clipper.AddPaths(curves, ClipperLib::ptSubject, true);
  const ClipperLib::IntRect box = clipper.GetBounds();
  const auto left = box.left - kMargin, right = box.right + kMargin;
  const auto top = box.top - kMargin, bottom = box.bottom + kMargin;
  const ClipperLib::Path frame = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  clipper.AddPath(frame, ClipperLib::ptSubject, true);
  clipper.ReverseSolution(true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNegative, ClipperLib::pftNegative);
  if (tree.ChildCount() == 1) return internal::FromTree(*tree.Childs[0]);
  // What should be below the frame is beside it: Clipper has forgotten where it lies.
  std::vector<Polygon> rings;
  for (const ClipperLib::PolyNode* ring = tree.GetFirst(); ring != nullptr; ring = ring->GetNext())
    if (!IsFrame(ring->Contour, frame)) rings.push_back(internal::FromPath(ring->Contour));
  return internal::FromRings(std::move(rings));
}

MultiPolygon OffsetTogether(const MultiPolygon& polygons, Coord distance_nm,
                            const OffsetOptions& options) {
  ClipperLib::Paths curves;
  ForEachRing(polygons, [&](const Polygon& ring) {
    curves.push_back(
        internal::ToPath(internal::OffsetCurve(ring, static_cast<double>(distance_nm), options)));
  });
  return distance_nm > 0 ? Outside(curves) : Inside(curves);
}

}  // namespace

MultiPolygon Offset(const MultiPolygon& polygons, Coord distance_nm, const OffsetOptions& options) {
  if (distance_nm == 0 || polygons.empty()) return polygons;
  const auto offset = [&](const MultiPolygon& part) {
    return OffsetTogether(part, distance_nm, options);
  };
  return distance_nm > 0 ? offset(polygons) : internal::ByIsland(polygons, offset);
}

MultiPolygon OffsetTwice(const MultiPolygon& polygons, Coord first_nm, Coord second_nm,
                         const OffsetOptions& options) {
  return Offset(Offset(polygons, first_nm, options), second_nm, options);
}

MultiPolygon OffsetLines(std::span<const Polyline> lines, Coord distance_nm, Cap cap,
                         const OffsetOptions& options) {
  // ClipperOffset calls libm: not for an output path.
  ClipperOffset offset(options.miter_limit, static_cast<double>(options.arc_tolerance_nm));
  for (const Polyline& line : lines)
    offset.AddPath(internal::ToPath(line), ToClipper(options.join), ToClipper(cap));
  ClipperLib::PolyTree tree;
  offset.Execute(tree, static_cast<double>(distance_nm));
  return internal::FromTree(tree);
}

}  // namespace slicefarm
