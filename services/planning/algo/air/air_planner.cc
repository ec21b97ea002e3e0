#include "services/planning/algo/air/air_planner.h"

#include "common/geometry/boolean/boolean.h"

namespace slicefarm::planning {

void AirPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  for (const ObjectSection& section : layer.sections) {
    if (!section.stack.IsPart()) continue;
    MultiPolygon& below = below_[section.stack.object];
    const MultiPolygon& outline = OutlineOf(section);
    if (section.layer > 0) {
      SectionPlan& section_plan = PlanOf(section.stack.id, plan);
      section_plan.air = Difference(Difference(outline, below), section_plan.above_supports);
    }
    below = outline;
  }
}

}  // namespace slicefarm::planning
