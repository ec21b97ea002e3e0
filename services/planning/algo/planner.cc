#include "services/planning/algo/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace slicefarm::planning {

SectionPlan& PlanOf(int32_t object, LayerPlan& plan) {
  const auto place = std::ranges::lower_bound(plan.sections, object, {}, &SectionPlan::object);
  if (place != plan.sections.end() && place->object == object) return *place;
  SectionPlan section;
  section.object = object;
  return *plan.sections.insert(place, std::move(section));
}

std::string NameOf(int32_t object, std::span<const std::string> names) {
  const auto index = static_cast<size_t>(object);
  return index < names.size() ? names[index] : fmt::format("object {}", object);
}

}  // namespace slicefarm::planning
