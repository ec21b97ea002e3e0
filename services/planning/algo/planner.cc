#include "services/planning/algo/planner.h"

#include <algorithm>

namespace slicefarm::planning {

SectionPlan& PlanOf(int32_t object, LayerPlan& plan) {
  const auto place = std::ranges::lower_bound(plan.sections, object, {}, &SectionPlan::object);
  if (place != plan.sections.end() && place->object == object) return *place;
  SectionPlan section;
  section.object = object;
  return *plan.sections.insert(place, std::move(section));
}

}  // namespace slicefarm::planning
