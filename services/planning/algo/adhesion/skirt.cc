#include "services/planning/algo/adhesion/skirt.h"

#include <algorithm>
#include <utility>

#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset.h"
#include "common/model/bead_section.h"

namespace slicefarm::planning {
namespace {

void AppendOuterPoints(const MultiPolygon& polygons, std::vector<Point>& points) {
  for (const PolygonWithHoles& island : polygons)
    points.insert(points.end(), island.outer.begin(), island.outer.end());
}

Path SkirtLoop(Polygon ring, const SkirtOptions& options) {
  Path path;
  path.feature = Feature::kSkirt;
  path.closed = true;
  path.points = std::move(ring);
  path.widths_nm = {options.width_nm};
  return path;
}

/// Of filament, that a loop takes on the first layer.
double FilamentNm(const Path& loop, const SkirtOptions& options) {
  return PathLength(loop) * SectionMm2(options.width_nm, options.height_nm) /
         options.filament_area_mm2;
}

}  // namespace

int32_t SkirtLayers(const SkirtOptions& options, int32_t layer_count) {
  if (options.loops <= 0) return 0;
  if (options.draft_shield == DraftShield::kEnabled) return layer_count;
  return std::clamp(options.height_layers, 0, std::max(layer_count, 0));
}

std::vector<Path> SkirtLoops(const MultiPolygon& parts, const MultiPolygon& brims,
                             const SkirtOptions& options) {
  const Coord spacing_nm = Spacing(options.width_nm, options.height_nm);
  if (options.loops <= 0 || spacing_nm <= 0) return {};
  std::vector<Point> points;
  AppendOuterPoints(parts, points);
  if (options.draft_shield == DraftShield::kDisabled) AppendOuterPoints(brims, points);
  const Polygon hull = ConvexHull(std::move(points));
  if (hull.size() < 3) return {};

  std::vector<Path> loops;
  double filament_nm = 0;
  const auto wanted = [&] {
    const auto made = static_cast<int32_t>(loops.size());
    return made < kMaxSkirtLoops &&
           (made < options.loops || filament_nm < static_cast<double>(options.min_length_nm));
  };
  Coord distance_nm = options.distance_nm + options.width_nm / 2;
  for (; wanted(); distance_nm += spacing_nm) {
    const MultiPolygon around = Offset({{hull, {}}}, distance_nm, {.join = Join::kRound});
    if (around.empty()) return {};  // a hull of a few nm
    loops.push_back(SkirtLoop(around.front().outer, options));
    filament_nm += FilamentNm(loops.back(), options);
  }
  std::reverse(loops.begin(), loops.end());
  return loops;
}

MultiPolygon ShieldKeepOut(const std::vector<Path>& loops, const SkirtOptions& options) {
  if (options.draft_shield == DraftShield::kDisabled || loops.empty()) return {};
  const OffsetOptions round{.join = Join::kRound};
  const MultiPolygon outer = Offset({{loops.front().points, {}}}, options.width_nm / 2, round);
  const MultiPolygon inner = Offset({{loops.back().points, {}}}, -options.width_nm / 2, round);
  MultiPolygon band = outer;
  for (const PolygonWithHoles& hole : inner)
    band.front().holes.emplace_back(hole.outer.rbegin(), hole.outer.rend());
  Canonicalize(band);
  return band;
}

}  // namespace slicefarm::planning
