#include "services/planning/algo/supports/generator/clearance.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/support_options.h"
#include "common/model/stack.h"
#include "services/planning/algo/supports/generator/tolerances.h"

namespace slicefarm::planning {
namespace {

/// Margin around a region within which the outlines of obstacles are used.
constexpr Coord kMarginNm = 1'000'000;

}  // namespace

Clearance::Clearance(const SupportProblem& problem, const SupportOptions& options, Coord top_nm,
                     int threads, const CancelToken& cancel)
    : problem_(problem), options_(options), bed_(Bounds(problem.bed)) {
  stacks_.emplace_back();
  const auto add = [&](const SolidLayer& layer) {
    if (layer.bottom_nm() < top_nm + options.top_gap_nm)
      stacks_.back().push_back({layer, {}, {}, {}});
  };
  for (const PartLayer& layer : problem.part) add(layer);
  for (const auto& other : problem.others) {
    stacks_.emplace_back();
    for (const SolidLayer& layer : other) add(layer);
  }
  std::vector<Layer*> all;
  for (Stack& stack : stacks_)
    for (Layer& layer : stack) all.push_back(&layer);
  ForEachIndex(threads, all.size(), [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    Layer& layer = *all[i];
    layer.box = Bounds(*layer.solid.outlines);
    layer.spaced = FastOffset(*layer.solid.outlines, XyGap(options_, layer.solid.bottom_nm()));
    layer.edged = FastOffset(*layer.solid.outlines, kEdgeNm);
  });
}

template <typename Visit>
void Clearance::ForEachBlocked(Coord bottom_nm, Coord top_nm, const Box& box, Visit visit) const {
  const Coord below = bottom_nm - options_.bottom_gap_nm;
  for (const Stack& stack : stacks_) {
    auto layer = std::partition_point(stack.begin(), stack.end(),
                                      [&](const Layer& l) { return l.solid.top_nm <= below; });
    for (; layer != stack.end(); ++layer) {
      const Coord above = layer->solid.bottom_nm() - top_nm;
      const Coord under = bottom_nm - layer->solid.top_nm;
      if (above >= options_.top_gap_nm) break;
      if (!layer->box.Intersects(box)) continue;
      const bool apart = under > -support::kSameHeightNm || above > -support::kSameHeightNm;
      const Coord clear = std::max(under, above);
      const Coord gap = under > above ? options_.bottom_gap_nm : options_.top_gap_nm;
      if (!apart)
        visit(layer->spaced);
      else if (clear < gap - support::kSameHeightNm)
        visit(layer->edged);
    }
  }
}

MultiPolygon Clearance::OnBed(MultiPolygon free, const Box& bounds) const {
  const bool inside =
      problem_.bed.empty() ||
      (problem_.bed.size() == 1 && problem_.bed[0].holes.empty() &&
       problem_.bed[0].outer.size() == 4 && bounds.min.x >= bed_.min.x &&
       bounds.max.x <= bed_.max.x && bounds.min.y >= bed_.min.y && bounds.max.y <= bed_.max.y);
  return inside ? free : Intersection(free, problem_.bed);
}

MultiPolygon Clearance::Free(const MultiPolygon& region, Coord bottom_nm, Coord top_nm) const {
  if (region.empty()) return {};
  const Box bounds = Bounds(region), box = bounds.Grown(kMarginNm);
  std::vector<Polygon> blocked;
  ForEachBlocked(bottom_nm, top_nm, box,
                 [&](const MultiPolygon& outlines) { AppendRingsNear(outlines, box, blocked); });
  return OnBed(blocked.empty() ? region : WithoutRings(region, blocked), bounds);
}

MultiPolygon Clearance::FreeOf(std::span<const Polygon> rings, Coord bottom_nm,
                               Coord top_nm) const {
  Box bounds;
  for (const Polygon& ring : rings) bounds.Add(Bounds(ring));
  if (bounds.Empty()) return {};
  const Box box = bounds.Grown(kMarginNm);
  std::vector<Polygon> blocked;
  ForEachBlocked(bottom_nm, top_nm, box,
                 [&](const MultiPolygon& outlines) { AppendRingsNear(outlines, box, blocked); });
  return OnBed(WithoutRings(rings, blocked), bounds);
}

void Clearance::FillBlocked(Coord bottom_nm, Coord top_nm, Bitmap& bitmap) const {
  const PixelGrid& grid = bitmap.grid();
  const Box box = {
      grid.origin,
      {grid.origin.x + grid.width * grid.pixel_nm, grid.origin.y + grid.height * grid.pixel_nm}};
  ForEachBlocked(bottom_nm, top_nm, box,
                 [&](const MultiPolygon& outlines) { bitmap.Fill(outlines); });
}

}  // namespace slicefarm::planning
