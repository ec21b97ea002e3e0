#include "services/beading/algo/extra_walls.h"

#include <cmath>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::beading {
namespace {

constexpr double kLeastShare = 0.3;
constexpr double kDepthInWalls = 1.5;
/// Half width of ribbons that represent outlines: the length of an outline inside a region is
/// measured as an area.
constexpr Coord kRibbonNm = 1'000;

MultiPolygon RibbonsOf(const MultiPolygon& outlines) {
  return Difference(Offset(outlines, kRibbonNm), Offset(outlines, -kRibbonNm));
}

}  // namespace

int32_t ExtraWalls(const PolygonWithHoles& island, const MultiPolygon& above,
                   const WallPlan& plan) {
  if (plan.perimeters == 0 || above.empty()) return 0;
  const Coord step = plan.inner_spacing_nm;
  const auto depth = static_cast<Coord>(std::llround(kDepthInWalls * static_cast<double>(step)));
  Coord thickness =
      plan.external_width_nm / 2 + plan.external_spacing_nm / 2 + (plan.perimeters - 1) * step;
  MultiPolygon inside = FastOffset({island}, -thickness);
  const MultiPolygon ribbons = Intersection(RibbonsOf(above), inside);
  const double least = kLeastShare * Area(RibbonsOf(above));
  int32_t extra = 0;
  while (!inside.empty() && Area(ribbons) > least) {
    const MultiPolygon deeper = FastOffset({island}, -thickness - depth);
    if (Area(Difference(Intersection(ribbons, inside), deeper)) <= least) break;
    ++extra;
    thickness += step;
    inside = FastOffset({island}, -thickness);
  }
  return extra;
}

}  // namespace slicefarm::beading
