#include "services/planning/algo/seams/seam_planner.h"

namespace slicefarm::planning {
namespace {

std::vector<Point> RearSeams(const MultiPolygon& outlines) {
  std::vector<Point> seams;
  for (const PolygonWithHoles& island : outlines) {
    seams.push_back(RearMost(island.outer));
    for (const Polygon& hole : island.holes) seams.push_back(RearMost(hole));
  }
  return seams;
}

}  // namespace

void SeamPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  for (const ObjectSection& section : layer.sections) {
    const SeamPosition seam = options_.objects[static_cast<size_t>(section.object)].seam;
    if (seam == SeamPosition::kNearest) continue;
    const MultiPolygon& outlines = OutlineOf(section);
    PlanOf(section.object, plan).seams = seam == SeamPosition::kRear
                                             ? RearSeams(outlines)
                                             : chains_[section.object].Next(outlines);
  }
}

}  // namespace slicefarm::planning
