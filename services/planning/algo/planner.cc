#include "services/planning/algo/planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace slicefarm::planning {

std::vector<LayerPlan> OpenLayers::TakeBelow(int32_t layer) {
  std::vector<LayerPlan> taken;
  for (; first_ < layer && !plans_.empty(); ++first_) {
    taken.push_back(std::move(plans_.front()));
    plans_.pop_front();
  }
  return taken;
}

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
