#include "services/slicing/algo/section/seam_area.h"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "common/geometry/boolean/union_of_many.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::slicing {
namespace {

constexpr Coord kBeyondAreaNm = 300'000;
constexpr Coord kBeyondSupportNm = 100'000;

/// Returns a rectangle around the segment that extends beyond both ends.
Polygon Around(Point a, Point b, Coord reach_nm) {
  const double scale = static_cast<double>(reach_nm) / Distance(a, b);
  const Point along = {std::llround(scale * static_cast<double>(b.x - a.x)),
                       std::llround(scale * static_cast<double>(b.y - a.y))};
  const Point left = {-along.y, along.x};
  return {a - along - left, b + along - left, b + along + left, a - along + left};
}

/// Returns the largest distance by which outlines may move.
Coord Moved(const RegionEdits& edits) {
  return std::abs(edits.grow_nm) + std::abs(edits.foot_nm) + std::abs(edits.widen_holes_nm);
}

}  // namespace

Coord SeamReach(const RegionEdits& edits) { return kBeyondAreaNm + Moved(edits); }

Coord SupportReach(const RegionEdits& edits) { return kBeyondSupportNm + Moved(edits); }

MultiPolygon AroundBody(const MultiPolygon& region, Coord reach_nm) {
  return FastOffset(region, reach_nm);
}

MultiPolygon AroundSurface(const Section& cut, Coord reach_nm, Coord resolution_nm,
                           const CancelToken& cancel) {
  std::vector<Polygon> rectangles;
  const auto add = [&](const Polyline& line) {
    const Polyline simple = SimplifyLine(line, resolution_nm);
    for (size_t i = 1; i < simple.size(); ++i)
      if (simple[i] != simple[i - 1])
        rectangles.push_back(Around(simple[i - 1], simple[i], reach_nm));
  };
  for (const Polyline& chain : cut.chains) add(chain);
  for (Polyline line : cut.loops) {
    line.push_back(line.front());
    add(line);
  }
  return UnionOfMany(std::move(rectangles), cancel);
}

}  // namespace slicefarm::slicing
