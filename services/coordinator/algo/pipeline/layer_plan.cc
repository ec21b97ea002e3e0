#include "services/coordinator/algo/pipeline/layer_plan.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"
#include "services/coordinator/algo/pipeline/seam_chain.h"

namespace slicefarm::coordinator {
namespace {

/// Layers of more islands are visited in the order in which they come.
constexpr size_t kMaxVisited = 2000;

std::vector<Point> RearSeams(const SlicedLayer& layer) {
  std::vector<Point> seams;
  for (const ObjectSection& section : layer.objects) {
    for (const PolygonWithHoles& island : section.outlines) {
      seams.push_back(RearMost(island.outer));
      for (const Polygon& hole : island.holes) seams.push_back(RearMost(hole));
    }
  }
  return seams;
}

double DistanceToBox(Point p, const Box& box) {
  const Point nearest{std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
  return Distance(p, nearest);
}

Point Nearest(const Polygon& ring, Point to) {
  return *std::min_element(ring.begin(), ring.end(), [to](Point a, Point b) {
    return SquaredNorm(a - to) < SquaredNorm(b - to);
  });
}

struct Island {
  const Polygon* ring = nullptr;
  Box box;
};

std::vector<Island> Islands(const SlicedLayer& layer) {
  std::vector<Island> islands;
  for (const ObjectSection& section : layer.objects) {
    for (const PolygonWithHoles& island : section.outlines) {
      islands.push_back({&island.outer, Bounds(island.outer)});
    }
  }
  return islands;
}

/// Where a layer that is entered at `entry` is left: its islands by nearest neighbour, each left
/// where it was entered. To guess that fill ends at an island's far side costs up to a quarter more
/// travel.
Point LikelyExit(const SlicedLayer& layer, Point entry) {
  std::vector<Island> left = Islands(layer);
  if (left.empty()) return entry;
  if (left.size() > kMaxVisited) return left.back().ring->front();
  Point at = entry;
  while (!left.empty()) {
    const auto next =
        std::min_element(left.begin(), left.end(), [&](const Island& a, const Island& b) {
          return DistanceToBox(at, a.box) < DistanceToBox(at, b.box);
        });
    at = Nearest(*next->ring, at);
    left.erase(next);
  }
  return at;
}

}  // namespace

absl::StatusOr<std::vector<LayerPlan>> PlanLayers(std::span<const SlicedLayer> layers,
                                                  SeamPosition seam, const CancelToken& cancel) {
  std::vector<LayerPlan> plans(layers.size());
  SeamChain chain;
  Point at;  // the corner of the bed, where start G-code leaves the nozzle as a rule
  for (size_t i = 0; i < layers.size(); ++i) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    if (seam == SeamPosition::kRear) plans[i].seams = RearSeams(layers[i]);
    if (seam == SeamPosition::kAligned) plans[i].seams = chain.Next(layers[i]);
    plans[i].entry = at;
    at = LikelyExit(layers[i], at);
  }
  return plans;
}

}  // namespace slicefarm::coordinator
