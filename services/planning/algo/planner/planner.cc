#include "services/planning/algo/planner/planner.h"

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

std::string NameOfCopy(size_t copy, std::span<const PlacedCopy> copies,
                       std::span<const std::string> names) {
  const int32_t object = copies[copy].object;
  const auto same = [&](const PlacedCopy& other) { return other.object == object; };
  std::string name = NameOf(object, names);
  if (std::ranges::count_if(copies, same) == 1) return name;
  return fmt::format("{} (copy {})", name, std::ranges::count_if(copies.first(copy + 1), same));
}

}  // namespace slicefarm::planning
