#include "services/planning/algo/curl/curl_planner.h"

#include <utility>

#include "common/model/options/planning_options.h"

namespace slicefarm::planning {

void CurlPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  for (const ObjectSection& section : layer.sections) {
    if (!section.stack.IsPart()) continue;
    const auto object = static_cast<size_t>(section.stack.object);
    const Coord width_nm = options_.objects[object].support.wall_width_nm;
    CurledEdges& edges = objects_.try_emplace(section.stack.object, width_nm).first->second;
    SectionPlan& section_plan = PlanOf(section.stack.id, plan);
    section_plan.curled =
        edges.Next(OutlineOf(section), section_plan.above_supports, section.height_nm);
  }
}

}  // namespace slicefarm::planning
