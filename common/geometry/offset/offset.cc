#include "common/geometry/offset/offset.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/boolean/arrangement.h"
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

/// Returns the region in which the winding number of `curves` is positive.
MultiPolygon Outside(const ClipperLib::Paths& curves) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(curves, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftPositive, ClipperLib::pftPositive);
  return internal::FromTree(tree);
}

/// Returns true if the ring is the frame; no other ring has the frame's corner.
bool IsFrame(const ClipperLib::Path& ring, const ClipperLib::Path& frame) {
  return std::find(ring.begin(), ring.end(), frame[0]) != ring.end();
}

/// Returns the same region as Outside for curves of rings that shrink. It calculates the holes of
/// the complement in a frame, because Clipper is more robust there (ClipperOffset does the same).
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
  // Clipper has lost the nesting: rings that should be below the frame in the tree are beside it.
  std::vector<Polygon> rings;
  for (const ClipperLib::PolyNode* ring = tree.GetFirst(); ring != nullptr; ring = ring->GetNext())
    if (!IsFrame(ring->Contour, frame)) rings.push_back(internal::FromPath(ring->Contour));
  return internal::FromRings(std::move(rings));
}

MultiPolygon OffsetTogether(const MultiPolygon& polygons, Coord distance_nm,
                            const OffsetOptions& options) {
  std::vector<internal::GroupedRing> rings;
  ForEachRing(polygons, [&](const Polygon& ring) {
    Polygon curve = internal::OffsetCurve(ring, static_cast<double>(distance_nm), options);
    if (curve.size() >= 3) rings.push_back({std::move(curve)});
  });
  if (auto fast = internal::TryWindingRegion(rings, 1)) return *std::move(fast);
  ClipperLib::Paths curves;
  for (const internal::GroupedRing& ring : rings) curves.push_back(internal::ToPath(ring.points));
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
  // ClipperOffset uses libm, so its result must not be used in the output.
  ClipperOffset offset(options.miter_limit, static_cast<double>(options.arc_tolerance_nm));
  for (const Polyline& line : lines)
    offset.AddPath(internal::ToPath(line), ToClipper(options.join), ToClipper(cap));
  ClipperLib::PolyTree tree;
  offset.Execute(tree, static_cast<double>(distance_nm));
  return internal::FromTree(tree);
}

}  // namespace slicefarm
