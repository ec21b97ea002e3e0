#include "common/geometry/boolean/boolean.h"

#include <utility>
#include <vector>

#include "common/geometry/boolean/by_island.h"
#include "common/geometry/boolean/clipper_convert.h"
#include "common/geometry/boolean/fast_boolean.h"
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

ClipperLib::ClipType ToClipper(Operation op) {
  switch (op) {
    case Operation::kUnion:
      return ClipperLib::ctUnion;
    case Operation::kIntersection:
      return ClipperLib::ctIntersection;
    case Operation::kDifference:
      return ClipperLib::ctDifference;
  }
  return ClipperLib::ctUnion;
}

MultiPolygon Execute(Operation op, const MultiPolygon& a, const MultiPolygon& b) {
  if (auto fast = TryBoolean(a, b, op)) return *std::move(fast);
  Paths subject, clip;
  internal::AppendRings(a, subject);
  internal::AppendRings(b, clip);
  return Execute(ToClipper(op), subject, clip, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
}

/// Region with the bounding boxes of its islands and rings, to find the part of the region near a
/// box.
class Surroundings {
 public:
  explicit Surroundings(const MultiPolygon& region) : region_(region) {
    for (const PolygonWithHoles& island : region) {
      std::vector<Box> boxes = {Bounds(island.outer)};
      for (const Polygon& hole : island.holes) boxes.push_back(Bounds(hole));
      boxes_.push_back(std::move(boxes));
    }
  }

  /// Returns a region that is equal to this region inside `box`: islands that meet the box, with
  /// the holes that meet it.
  MultiPolygon Near(const Box& box) const {
    MultiPolygon near;
    for (size_t i = 0; i < region_.size(); ++i) {
      if (!boxes_[i][0].Intersects(box)) continue;
      PolygonWithHoles& island = near.emplace_back(PolygonWithHoles{region_[i].outer, {}});
      for (size_t k = 0; k < region_[i].holes.size(); ++k)
        if (boxes_[i][k + 1].Intersects(box)) island.holes.push_back(region_[i].holes[k]);
    }
    return near;
  }

 private:
  const MultiPolygon& region_;
  std::vector<std::vector<Box>> boxes_;
};

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
  return Execute(Operation::kUnion, a, b);
}

MultiPolygon Difference(const MultiPolygon& a, const MultiPolygon& b) {
  const Surroundings surroundings(b);
  return internal::ByIsland(a, [&](const MultiPolygon& island) {
    const MultiPolygon near = surroundings.Near(Bounds(island));
    return near.empty() ? island : Execute(Operation::kDifference, island, near);
  });
}

MultiPolygon Intersection(const MultiPolygon& a, const MultiPolygon& b) {
  const Surroundings surroundings(b);
  return internal::ByIsland(a, [&](const MultiPolygon& island) {
    const MultiPolygon near = surroundings.Near(Bounds(island));
    return near.empty() ? MultiPolygon() : Execute(Operation::kIntersection, island, near);
  });
}

}  // namespace slicefarm
