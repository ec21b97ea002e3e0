#include "services/beading/algo/classic/constant_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/grown_area.h"
#include "common/geometry/offset/offset.h"
#include "common/model/bead_section.h"

namespace slicefarm::beading {
namespace {

/// Share of a spacing by which opposite walls may be too close. If they are closer, gap fill
/// replaces them.
constexpr double kFitTolerance = 0.15;
/// Amount by which beads are grown before they are subtracted from a region. It prevents slivers at
/// edges that should coincide but differ by rounding.
constexpr Coord kSafetyNm = 5'000;
constexpr Coord kRoundingNm = 10;

void AppendGaps(const MultiPolygon& regions, bool along_outline, std::vector<Gap>& gaps) {
  for (const PolygonWithHoles& region : regions) gaps.push_back({region, along_outline});
}

/// Returns true if the region has no tips and is nowhere narrower than twice the distance. Opening
/// it by this distance changes nothing.
bool IsWideThroughout(const MultiPolygon& region, Coord distance_nm) {
  return std::all_of(region.begin(), region.end(), [&](const PolygonWithHoles& island) {
    const auto inset = TryOffset({island}, -distance_nm);
    return inset && !inset->has_tips;
  });
}

/// Returns a shrunk region grown again. Corners of at least 39 degrees keep their tips (miter limit
/// 3). A wall that avoided the tip of a tooth would leave a gap there, and the bead in the gap
/// would be outside of the wall.
MultiPolygon Regrown(const MultiPolygon& core, Coord distance_nm) {
  constexpr double kMiterLimit = 3;
  if (auto clean = TryOffset(core, distance_nm); clean && !clean->has_tips)
    return std::move(clean->polygons);
  return Offset(core, distance_nm, {.miter_limit = kMiterLimit});
}

/// Returns the part of `region` where discs of `radius_nm` fit, with sharp corners kept. `core`
/// contains the centres of these discs.
MultiPolygon Opened(const MultiPolygon& region, const MultiPolygon& core, Coord radius_nm) {
  if (core.empty()) return {};
  return Intersection(region, Regrown(core, radius_nm + kRoundingNm));
}

/// Returns the part of `region` that discs of `radius_nm` around `core` do not cover.
MultiPolygon Residue(const MultiPolygon& region, const MultiPolygon& core, Coord radius_nm) {
  if (core.empty()) return region;
  return Difference(region, Regrown(core, radius_nm + kSafetyNm));
}

/// Returns true if discs of `radius_nm` around `core` certainly reach all of `area` except for
/// parts that are together smaller than `least_area_nm2`. If the core still has a ring for each
/// ring of the area, no part between two discs is lost, so that the growth does not overlap itself.
bool ReachesMost(const PolygonWithHoles& area, const MultiPolygon& core, Coord radius_nm,
                 double least_area_nm2) {
  if (core.size() != 1 || core[0].holes.size() != area.holes.size()) return false;
  return Area(area) - LeastGrownArea(core[0], radius_nm) < least_area_nm2;
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
    MultiPolygon centre = FastOffset(region, -to_centre);
    const bool makes_way = inset > 0 || plan.thin_walls;
    if (makes_way && !IsWideThroughout(region, to_centre + fit)) {
      const MultiPolygon core = FastOffset(centre, -fit);
      centre = Opened(centre, core, fit);
      if (inset == 0 || plan.gap_fill)
        AppendGaps(Residue(region, core, fit + to_centre), inset == 0, walls.gaps);
    }
    const bool has_next = inset == 0 && plan.perimeters > 1;
    region = FastOffset(centre, -spacing / 2 - (has_next ? plan.apart_nm : 0));
    walls.centre_lines.push_back(std::move(centre));
  }
  walls.fill_area = std::move(region);
  return walls;
}

NarrowParts FindNarrowParts(const PolygonWithHoles& area, Coord width_nm, double least_area_nm2) {
  const Coord half = width_nm / 2;
  if (IsWideThroughout({area}, half)) return {};
  const MultiPolygon core = FastOffset({area}, -half);
  if (ReachesMost(area, core, half, least_area_nm2)) return {};
  return {Residue({area}, core, half), core.empty()};
}

}  // namespace slicefarm::beading
