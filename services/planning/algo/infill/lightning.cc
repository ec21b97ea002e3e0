#include "services/planning/algo/infill/lightning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/measure.h"
#include "services/planning/algo/infill/grid_points.h"
#include "services/planning/algo/infill/lightning_trees.h"

namespace slicefarm::planning {
namespace {

/// Point of solid infill that needs support, and its distance from the nearest support.
struct Burden {
  Point at;
  double distance_nm = 0;
};

/// Returns the points of a roof that need support. `walls_nm`: length by which walls reach farther
/// than branches.
std::vector<Burden> BurdensOf(const MultiPolygon& roof, const RegionEdges& area,
                              const LightningTrees& branches, double radius_nm, double walls_nm) {
  const double step = std::max(radius_nm / 2, std::sqrt(Area(roof) / kMaxRoofPoints));
  std::vector<Burden> burdens;
  for (const Point p : GridPoints(roof, std::max<Coord>(1, std::llround(step)))) {
    const auto edge = area.Nearest(p);
    const auto tree = branches.NearestTo(p);
    constexpr double kFar = std::numeric_limits<double>::infinity();
    burdens.push_back({p, std::min(edge.has_value() ? edge->distance_nm - walls_nm : kFar,
                                   tree.has_value() ? tree->first.distance_nm : kFar)});
  }
  return burdens;
}

void Support(std::vector<Burden> burdens, const RegionEdges& area, double radius_nm,
             LightningTrees& branches) {
  while (!burdens.empty()) {
    const Burden farthest = *std::ranges::max_element(burdens, {}, &Burden::distance_nm);
    if (farthest.distance_nm <= radius_nm) return;
    const Point from = branches.GrowTo(farthest.at, area);
    for (Burden& burden : burdens)
      burden.distance_nm =
          std::min(burden.distance_nm, DistanceToSegment(burden.at, from, farthest.at));
  }
}

}  // namespace

std::vector<std::vector<Polyline>> LightningLines(const ObjectStack& stack,
                                                  std::span<const MultiPolygon> areas,
                                                  std::span<const MultiPolygon> roofs,
                                                  const LightningRules& rules) {
  std::vector<std::vector<Polyline>> lines(stack.size());
  LightningTrees branches;
  for (size_t i = stack.size(); i-- > 0;) {
    if (i + 1 < stack.size()) {
      const auto step_nm = static_cast<double>(stack[i + 1].height_nm);
      branches.Descend(rules.prune * step_nm, rules.straighten * step_nm);
    }
    const RegionEdges area(areas[i]);
    branches.Refit(area);
    const double walls_nm = (rules.overhang - 1) * static_cast<double>(stack[i].height_nm);
    Support(BurdensOf(roofs[i], area, branches, rules.radius_nm, walls_nm), area, rules.radius_nm,
            branches);
    lines[i] = branches.Lines(rules.beyond_nm);
  }
  return lines;
}

}  // namespace slicefarm::planning
