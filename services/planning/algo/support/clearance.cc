#include "services/planning/algo/support/clearance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::planning {
namespace {

/// Heights that differ by less are the same.
constexpr Coord kSameHeightNm = 1'000;
/// Boxes are cut this far from what is looked at.
constexpr Coord kMarginNm = 1'000'000;
/// How much of the gap is kept in space at the edge of a step. All of it would leave most of a
/// narrow step without a surface at the distance asked for: see README.md.
constexpr double kCornerShare = 0.5;

}  // namespace

Coord CornerClearance(Coord clear_nm, Coord gap_nm, Coord both_heights_nm, double share) {
  const double r = both_heights_nm / 2.0;
  const double far = gap_nm * share + r, up = clear_nm + r;
  if (far <= up) return 0;
  return std::max<Coord>(0, std::llround(std::sqrt(far * far - up * up) - r));
}

Clearance::Clearance(const SupportProblem& problem, const SupportOptions& options, int threads)
    : problem_(problem), options_(options), bed_(Bounds(problem.bed)) {
  stacks_.emplace_back();
  for (const PartLayer& layer : problem.part) stacks_[0].push_back({layer, {}, {}, {}});
  for (const auto& other : problem.others) {
    stacks_.emplace_back();
    for (const SolidLayer& layer : other) stacks_.back().push_back({layer, {}, {}, {}});
  }
  std::vector<Layer*> all;
  for (Stack& stack : stacks_)
    for (Layer& layer : stack) all.push_back(&layer);
  ForEachIndex(threads, all.size(), [&](size_t i, int) {
    Layer& layer = *all[i];
    layer.box = Bounds(*layer.solid.outlines);
    layer.spaced = FastOffset(*layer.solid.outlines, options_.xy_gap_nm);
    const Coord corner =
        CornerClearance(0, options_.top_gap_nm, 2 * options_.layer_height_nm, kCornerShare);
    if (corner > 0) layer.cornered = FastOffset(*layer.solid.outlines, corner);
  });
}

void Clearance::AppendLayer(const Layer& layer, Coord clear_nm, Coord gap_nm, const Box& box,
                            std::vector<Polygon>& rings) const {
  if (clear_nm < -kSameHeightNm) return AppendRingsNear(layer.spaced, box, rings);
  if (clear_nm > gap_nm - kSameHeightNm) return;
  const Coord touching =
      CornerClearance(0, options_.top_gap_nm, 2 * options_.layer_height_nm, kCornerShare);
  const Coord corner = CornerClearance(std::max<Coord>(0, clear_nm), gap_nm,
                                       2 * options_.layer_height_nm, kCornerShare);
  if (corner == 0) return AppendRingsNear(*layer.solid.outlines, box, rings);
  if (corner == touching) return AppendRingsNear(layer.cornered, box, rings);
  AppendRingsNear(FastOffset(*layer.solid.outlines, corner), box, rings);
}

void Clearance::AppendBlocked(const Stack& stack, Coord bottom_nm, Coord top_nm, const Box& box,
                              std::vector<Polygon>& rings) const {
  const Coord below = bottom_nm - options_.bottom_gap_nm;
  auto layer = std::partition_point(stack.begin(), stack.end(),
                                    [&](const Layer& l) { return l.solid.top_nm <= below; });
  for (; layer != stack.end(); ++layer) {
    const Coord above = layer->solid.bottom_nm() - top_nm, under = bottom_nm - layer->solid.top_nm;
    if (above >= options_.top_gap_nm) break;
    if (!layer->box.Intersects(box)) continue;
    if (under > above)
      AppendLayer(*layer, under, options_.bottom_gap_nm, box, rings);
    else
      AppendLayer(*layer, above, options_.top_gap_nm, box, rings);
  }
}

MultiPolygon Clearance::Free(const MultiPolygon& region, Coord bottom_nm, Coord top_nm) const {
  if (region.empty()) return {};
  const Box bounds = Bounds(region);
  const Box box = bounds.Grown(kMarginNm);
  std::vector<Polygon> rings;
  for (const Stack& stack : stacks_) AppendBlocked(stack, bottom_nm, top_nm, box, rings);
  MultiPolygon free = rings.empty() ? region : WithoutRings(region, rings);
  const bool on_bed =
      problem_.bed.empty() ||
      (problem_.bed.size() == 1 && problem_.bed[0].holes.empty() &&
       problem_.bed[0].outer.size() == 4 && bounds.min.x >= bed_.min.x &&
       bounds.max.x <= bed_.max.x && bounds.min.y >= bed_.min.y && bounds.max.y <= bed_.max.y);
  return on_bed ? free : Intersection(free, problem_.bed);
}

}  // namespace slicefarm::planning
