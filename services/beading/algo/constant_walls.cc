#include "services/beading/algo/constant_walls.h"

#include <utility>

#include "common/geometry/boolean.h"
#include "common/geometry/offset.h"
#include "common/model/bead_section.h"

namespace slicefarm::beading {
namespace {

/// Opposite walls may come this part of a spacing closer than side by side before they make way for
/// gap fill.
constexpr double kFitTolerance = 0.15;
/// Beads are grown by this much before they are taken away from a region, so that edges that should
/// coincide but for rounding leave no slivers.
constexpr Coord kSafetyNm = 5'000;
constexpr Coord kRoundingNm = 10;

void AppendGaps(const MultiPolygon& regions, bool along_outline, std::vector<Gap>& gaps) {
  for (const PolygonWithHoles& region : regions) gaps.push_back({region, along_outline});
}

/// The part of `region` that an opening by `radius_nm` leaves: where a disc of that radius fits,
/// with sharp corners kept.
MultiPolygon Opened(const MultiPolygon& region, Coord radius_nm) {
  const MultiPolygon core = Offset(region, -radius_nm);
  if (core.empty()) return {};
  return Intersection(region, Offset(core, radius_nm + kRoundingNm));
}

}  // namespace

WallPlan WallPlan::Make(int perimeters, Coord external_width_nm, Coord inner_width_nm,
                        Coord layer_height_nm) {
  WallPlan plan;
  plan.perimeters = perimeters;
  plan.external_width_nm = external_width_nm;
  plan.inner_width_nm = inner_width_nm;
  plan.external_spacing_nm = Spacing(external_width_nm, layer_height_nm);
  plan.inner_spacing_nm = Spacing(inner_width_nm, layer_height_nm);
  return plan;
}

IslandWalls MakeConstantWalls(const PolygonWithHoles& island, const WallPlan& plan) {
  IslandWalls walls;
  MultiPolygon region = {island};
  for (int inset = 0; inset < plan.perimeters && !region.empty(); ++inset) {
    const Coord spacing = inset == 0 ? plan.external_spacing_nm : plan.inner_spacing_nm;
    const Coord to_centre = (inset == 0 ? plan.external_width_nm : spacing) / 2;
    const Coord fit = std::llround(static_cast<double>(spacing) / 2 * (1 - kFitTolerance));
    MultiPolygon centre = Opened(Offset(region, -to_centre), fit);
    if (plan.gap_fill) {
      AppendGaps(Difference(region, Offset(centre, to_centre + kSafetyNm)), inset == 0, walls.gaps);
    }
    region = Offset(centre, -spacing / 2);
    walls.centre_lines.push_back(std::move(centre));
  }
  if (plan.gap_fill && plan.perimeters > 0) {
    walls.fill_area = Opened(region, plan.max_gap_width_nm / 2);
    AppendGaps(Difference(region, Offset(walls.fill_area, kSafetyNm)), false, walls.gaps);
  } else {
    walls.fill_area = std::move(region);
  }
  return walls;
}

}  // namespace slicefarm::beading
