#include "services/planning/algo/supports/generator/overhangs.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/bridges.h"
#include "services/planning/algo/supports/generator/tolerances.h"

namespace slicefarm::planning {
namespace {

/// Overhang that counts as steep where supports are enforced.
constexpr Coord kEnforcedNm = 50'000;
/// Angle added to support_material_threshold, so that slopes of exactly this angle are supported,
/// as in PrusaSlicer and OrcaSlicer; and the largest sum.
constexpr double kDegree = std::numbers::pi / 180, kSteepest = 89 * kDegree;
/// Distance by which supports extend beyond the steep area along a step. Without it, a step that is
/// in some sections narrower than the threshold would have supports in pieces.
constexpr Coord kAlongNm = 500'000;
/// Least reach of a cantilever beyond the layer below, as in OrcaSlicer.
constexpr Coord kCantileverNm = 3'000'000;
constexpr OffsetOptions kRound = {.join = Join::kRound, .arc_tolerance_nm = 10'000};

const MultiPolygon& Below(const SupportProblem& problem, size_t index) {
  return *problem.part[index - 1].outlines;
}

/// Returns the parts of `hanging` (the area beyond `below`) that are farther than `distance_nm`
/// from `below`.
MultiPolygon FartherThan(const MultiPolygon& hanging, const MultiPolygon& below,
                         Coord distance_nm) {
  // Offsets only the rings near each island. An island without such rings is far as a whole.
  MultiPolygon far;
  for (const PolygonWithHoles& island : hanging) {
    const Box box = Bounds(island.outer).Grown(2 * distance_nm);
    std::vector<Polygon> rings;
    AppendRingsNear(below, box, rings);
    if (rings.empty()) {
      far.push_back(island);
      continue;
    }
    const MultiPolygon near = Union(rings, FillRule::kNonZero);
    MultiPolygon rest = Difference({island}, Offset(near, distance_nm, kRound));
    std::move(rest.begin(), rest.end(), std::back_inserter(far));
  }
  std::erase_if(
      far, [](const PolygonWithHoles& island) { return Area(island) < support::kLeastRegionNm2; });
  Canonicalize(far);
  return far;
}

/// Returns true if some point of the island may be farther than `distance_nm` from the rest of its
/// layer. A small or thin island cannot.
bool MayReach(const PolygonWithHoles& island, Coord distance_nm) {
  const Box box = Bounds(island.outer);
  return std::max(box.max.x - box.min.x, box.max.y - box.min.y) > distance_nm &&
         Area(island) > support::kLeastRegionNm2;
}

/// Removes the parts of `steep` that are neither an island in the air nor a part of a cantilever.
void KeepCritical(const MultiPolygon& hanging, const MultiPolygon& below,
                  const MultiPolygon& in_air, MultiPolygon& steep) {
  const MultiPolygon far = FartherThan(hanging, below, kCantileverNm);
  std::erase_if(steep, [&](const PolygonWithHoles& island) {
    return Intersection({island}, far).empty() && Intersection({island}, in_air).empty();
  });
}

}  // namespace

Coord OverhangThreshold(const SupportOptions& options, Coord height_nm, Coord below_height_nm) {
  if (options.threshold_rad <= 0 && options.threshold_overlap >= 0) {
    const auto width_nm = static_cast<double>(options.wall_width_nm);
    return std::llround(width_nm * (1 - options.threshold_overlap));
  }
  if (options.threshold_rad <= 0)
    return options.style == SupportStyle::kTree ? options.wall_width_nm * 2 / 3
                                                : options.wall_width_nm / 2;
  const double angle_rad = std::min(options.threshold_rad + kDegree, kSteepest);
  return std::llround((height_nm + below_height_nm) / 2.0 / Tan(angle_rad));
}

MultiPolygon IslandsInAirOf(const SupportProblem& problem, size_t index) {
  MultiPolygon islands;
  if (index == 0) return islands;
  for (const PolygonWithHoles& island : *problem.part[index].outlines)
    if (Intersection({island}, Below(problem, index)).empty()) islands.push_back(island);
  return islands;
}

Overhang OverhangOf(const SupportProblem& problem, size_t index, const SupportOptions& options) {
  Overhang overhang;
  if (index == 0) return overhang;
  const PartLayer& layer = problem.part[index];
  const MultiPolygon& below = Below(problem, index);
  const bool enforced_layer = static_cast<int32_t>(index) < options.enforced_layers;
  if (!options.automatic && !enforced_layer && layer.enforcers == nullptr) return overhang;
  MultiPolygon hanging = Difference(*layer.outlines, below);
  std::erase_if(hanging, [](const PolygonWithHoles& i) { return !MayReach(i, kEnforcedNm); });
  if (hanging.empty()) return overhang;
  const Coord threshold =
      OverhangThreshold(options, layer.height_nm, problem.part[index - 1].height_nm);
  if (options.automatic) {
    overhang.steep = FartherThan(hanging, below, threshold);
    if (options.critical_only && !enforced_layer && !overhang.steep.empty())
      KeepCritical(hanging, below, IslandsInAirOf(problem, index), overhang.steep);
    if (options.skip_bridges && !overhang.steep.empty() && !enforced_layer) {
      const MultiPolygon bridges =
          BridgesOf(hanging, overhang.steep, below,
                    {options.wall_width_nm, options.walls_nm, options.max_bridge_nm});
      overhang.steep = Difference(overhang.steep, bridges);
      if (!overhang.steep.empty()) hanging = Difference(hanging, bridges);
    }
  }
  Coord reach = threshold;
  if (enforced_layer || layer.enforcers != nullptr) {
    MultiPolygon enforced = FartherThan(hanging, below, kEnforcedNm);
    if (!enforced_layer) enforced = Intersection(enforced, *layer.enforcers);
    overhang.steep = Union(overhang.steep, enforced);
    reach = std::max(reach, kEnforcedNm);
  }
  if (layer.blockers != nullptr) {
    overhang.steep = Difference(overhang.steep, *layer.blockers);
    hanging = Difference(hanging, *layer.blockers);
  }
  std::erase_if(overhang.steep, [](const PolygonWithHoles& island) {
    return Area(island) < support::kLeastRegionNm2;
  });
  if (!overhang.steep.empty())
    overhang.contact = Intersection(hanging, FastOffset(overhang.steep, reach + kAlongNm));
  return overhang;
}

void KeepSteep(const SupportProblem& problem, size_t index, const SupportOptions& options,
               MultiPolygon steep, Overhang& overhang) {
  overhang.steep = std::move(steep);
  if (overhang.steep.empty()) {
    overhang.contact.clear();
    return;
  }
  const Coord threshold =
      OverhangThreshold(options, problem.part[index].height_nm, problem.part[index - 1].height_nm);
  const Coord reach = std::max(threshold, kEnforcedNm) + kAlongNm;
  overhang.contact = Intersection(overhang.contact, FastOffset(overhang.steep, reach));
}

}  // namespace slicefarm::planning
