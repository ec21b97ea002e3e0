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

SectionPlan& PlanOf(int32_t stack, LayerPlan& plan) {
  const auto place = std::ranges::lower_bound(plan.sections, stack, {}, &SectionPlan::stack);
  if (place != plan.sections.end() && place->stack == stack) return *place;
  SectionPlan section;
  section.stack = stack;
  return *plan.sections.insert(place, std::move(section));
}

std::string NameOf(int32_t object, std::span<const std::string> names) {
  const auto index = static_cast<size_t>(object);
  return index < names.size() ? names[index] : fmt::format("object {}", object);
}

}  // namespace slicefarm::planning
