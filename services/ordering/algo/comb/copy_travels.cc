#include "services/ordering/algo/comb/copy_travels.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "services/ordering/algo/comb/curl_avoidance.h"

namespace slicefarm::ordering {
namespace {

/// Distance in nm by which a detour may extend beyond the bounding box of its two ends.
constexpr Coord kMarginNm = 20 * kNmPerMm;

struct Obstacle {
  PolygonWithHoles area;  ///< curled area, in plate coordinates
  Box box;
  int32_t pass = 0;
};

Box Common(const Box& a, const Box& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

const PathBlock& BlockOf(const BlockVisit& visit, const OrderedLayer& layer) {
  return layer.blocks[static_cast<size_t>(visit.block)];
}

std::vector<Obstacle> ObstaclesOf(const LayerPlan& plan, const OrderedLayer& layer) {
  std::vector<Obstacle> obstacles;
  for (const BlockVisit& visit : layer.visits) {
    const SectionPlan* section = FindPlan(BlockOf(visit, layer).stack.id, plan.sections);
    if (section == nullptr) continue;
    for (PolygonWithHoles& area : Moved(section->curled, visit.shift)) {
      const Box box = Bounds(area.outer);
      obstacles.push_back({std::move(area), box, visit.pass});
    }
  }
  return obstacles;
}

/// Returns the bounding box of the beads of the pass. The bed is at least as large.
Box BoundsOf(const OrderedLayer& layer, int32_t pass) {
  Box bounds;
  for (const BlockVisit& visit : layer.visits) {
    if (visit.pass != pass) continue;
    for (const Path& path : BlockOf(visit, layer).paths) {
      const Box box = Bounds(path.points);
      bounds.Add(Box{box.min + visit.shift, box.max + visit.shift});
    }
  }
  return bounds;
}

}  // namespace

void KeepOffCurled(const LayerPlan& plan, WorkBudget& sights, OrderedLayer& layer) {
  const std::vector<Obstacle> obstacles = ObstaclesOf(plan, layer);
  if (obstacles.empty()) return;
  Box beads;
  for (size_t i = 0; i < layer.visits.size(); ++i) {
    BlockVisit& visit = layer.visits[i];
    const bool begins = i == 0 || layer.visits[i - 1].pass != visit.pass;
    if (begins) {
      beads = BoundsOf(layer, visit.pass);
      continue;
    }
    const BlockVisit& last = layer.visits[i - 1];
    const Point from = last.shift + EndOf(BlockOf(last, layer).paths.back());
    const Point to = visit.shift + StartOf(BlockOf(visit, layer).paths.front());
    Box ends;
    ends.Add(from);
    ends.Add(to);
    const Box bounds = Common(ends.Grown(kMarginNm), beads);
    MultiPolygon near;
    for (const Obstacle& obstacle : obstacles)
      if (obstacle.pass == visit.pass && obstacle.box.Intersects(bounds))
        near.push_back(obstacle.area);
    CurlAvoidance routes(Union(near, {}), bounds);
    routes.KeepOff(from, to, sights, visit.corners);
  }
}

}  // namespace slicefarm::ordering
