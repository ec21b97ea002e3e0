#include "common/geometry/offset.h"

#include "common/geometry/by_island.h"
#include "common/geometry/clipper_convert.h"

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

ClipperOffset MakeOffset(const OffsetOptions& options) {
  return ClipperOffset(options.miter_limit, static_cast<double>(options.arc_tolerance_nm));
}

MultiPolygon Execute(ClipperOffset& offset, Coord distance_nm) {
  ClipperLib::PolyTree tree;
  offset.Execute(tree, static_cast<double>(distance_nm));
  return internal::FromTree(tree);
}

MultiPolygon OffsetTogether(const MultiPolygon& polygons, Coord distance_nm,
                            const OffsetOptions& options) {
  ClipperOffset offset = MakeOffset(options);
  ClipperLib::Paths paths;
  internal::AppendRings(polygons, paths);
  offset.AddPaths(paths, ToClipper(options.join), ClipperLib::etClosedPolygon);
  return Execute(offset, distance_nm);
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
  ClipperOffset offset = MakeOffset(options);
  for (const Polyline& line : lines)
    offset.AddPath(internal::ToPath(line), ToClipper(options.join), ToClipper(cap));
  return Execute(offset, distance_nm);
}

}  // namespace slicefarm
