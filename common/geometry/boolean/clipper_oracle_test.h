#pragma once

#include "common/geometry/boolean/clipper_convert.h"
#include "common/geometry/boolean/fast_boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm {

// Functions of Clipper without slicefarm's algorithms. Tests compare slicefarm's results with
// them.

inline MultiPolygon ClipperBoolean(const MultiPolygon& a, const MultiPolygon& b,
                                   ClipperLib::ClipType type) {
  ClipperLib::Paths subject, clip;
  internal::AppendRings(a, subject);
  internal::AppendRings(b, clip);
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(type, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return internal::FromTree(tree);
}

inline MultiPolygon ClipperBoolean(const MultiPolygon& a, const MultiPolygon& b, Operation op) {
  if (op == Operation::kUnion) return ClipperBoolean(a, b, ClipperLib::ctUnion);
  return ClipperBoolean(
      a, b, op == Operation::kIntersection ? ClipperLib::ctIntersection : ClipperLib::ctDifference);
}

/// Returns the area of the symmetric difference of two regions, in mm2.
inline double Apart(const MultiPolygon& a, const MultiPolygon& b) {
  return Area(ClipperBoolean(a, b, ClipperLib::ctXor)) / 1e12;
}

inline MultiPolygon ClipperOffsetTogether(const MultiPolygon& region, Coord distance_nm,
                                          const OffsetOptions& options) {
  const auto join = options.join == Join::kRound    ? ClipperLib::jtRound
                    : options.join == Join::kSquare ? ClipperLib::jtSquare
                                                    : ClipperLib::jtMiter;
  ClipperLib::ClipperOffset offset(options.miter_limit,
                                   static_cast<double>(options.arc_tolerance_nm));
  ClipperLib::Paths rings;
  internal::AppendRings(region, rings);
  offset.AddPaths(rings, join, ClipperLib::etClosedPolygon);
  ClipperLib::PolyTree tree;
  offset.Execute(tree, static_cast<double>(distance_nm));
  return internal::FromTree(tree);
}

/// Shrinks islands one by one.
inline MultiPolygon ClipperOffset(const MultiPolygon& region, Coord distance_nm,
                                  const OffsetOptions& options = {}) {
  if (distance_nm > 0) return ClipperOffsetTogether(region, distance_nm, options);
  MultiPolygon all;
  for (const PolygonWithHoles& island : region)
    for (PolygonWithHoles& part : ClipperOffsetTogether({island}, distance_nm, options))
      all.push_back(std::move(part));
  Canonicalize(all);
  return all;
}

}  // namespace slicefarm
