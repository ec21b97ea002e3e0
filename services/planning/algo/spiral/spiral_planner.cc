#include "services/planning/algo/spiral/spiral_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/rings/loop_point.h"
#include "common/model/spiral.h"

namespace slicefarm::planning {
namespace {

bool WindsUp(const ObjectPlanOptions& object) { return object.spiral.width_nm > 0; }

absl::Status Refused(std::string why, std::string_view got) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   "spiral_vase = 1: " + std::move(why),
                   {{"setting", "spiral_vase"}, {"value", "1"}, {"got", std::string(got)}});
}

/// Returns the only section of a layer that is not empty; null if there are none or several.
const ObjectSection* OnlySection(const SlicedLayer& layer) {
  const ObjectSection* only = nullptr;
  for (const ObjectSection& section : layer.sections) {
    if (section.regions.empty()) continue;
    if (only != nullptr) return nullptr;
    only = &section;
  }
  return only;
}

}  // namespace

bool SpiralPlanner::IsNeeded(const PlanningOptions& options) {
  return std::ranges::any_of(options.objects, WindsUp);
}

absl::Status SpiralPlanner::Check(const PlanningOptions& options,
                                  std::span<const PlacedCopy> copies) {
  if (!IsNeeded(options) || copies.empty()) return absl::OkStatus();
  for (const PlacedCopy& copy : copies)
    if (copy.object != copies.front().object)
      return Refused("spiral_vase prints one object, but the plate has several", "objects");
  if (copies.size() > 1 && !options.sequence.complete_objects)
    return Refused(fmt::format("spiral_vase prints one copy, but the plate has {}; add "
                               "complete_objects = 1 to print them one after the other",
                               copies.size()),
                   "copies");
  return absl::OkStatus();
}

std::optional<Polygon> SpiralPlanner::LoopOf(const SlicedLayer& layer) const {
  const ObjectSection* section = OnlySection(layer);
  if (section == nullptr || !section->hollow || section->regions.size() > 1) return std::nullopt;
  const auto object = static_cast<size_t>(section->stack.object);
  return SpiralLoop(OutlineOf(*section), options_.objects[object].spiral.width_nm);
}

void SpiralPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  ++seen_;
  const bool hollow = std::ranges::any_of(layer.sections, &ObjectSection::hollow);
  const bool beside_skirt = skirt_reach_.Next(layer);
  const std::optional<Polygon> loop = hollow && !beside_skirt ? LoopOf(layer) : std::nullopt;
  if (hollow) ++hollow_;
  if (hollow && !loop) no_turns_nm_.push_back(layer.frame.print_z_nm);
  goes_on_ = loop && left_at_;
  if (!loop) {
    left_at_.reset();
    return;
  }
  const Stack& stack = OnlySection(layer)->stack;
  SectionPlan& section = PlanOf(stack.id, plan);
  const Point start = NearestLoopPoint(*loop, left_at_.value_or(section.entry)).at;
  section.spiral = {.start = start,
                    .from = left_at_,
                    .last = true,
                    .blends = options_.objects[static_cast<size_t>(stack.object)].spiral.blends};
  left_at_ = start;
}

int32_t SpiralPlanner::Revise(OpenLayers& layers) {
  const int32_t last = seen_ - 1;
  if (!goes_on_) return left_at_ ? last : layers.end();
  LayerPlan& below = layers.At(last - 1);
  LayerPlan& above = layers.At(last);
  const auto turn_of = [](LayerPlan& plan) -> SectionPlan& {
    return *std::ranges::find_if(
        plan.sections, [](const SectionPlan& section) { return section.spiral.has_value(); });
  };
  turn_of(below).spiral->last = false;
  below.ends_ready = above.begins_ready = true;
  if (copies_.size() == 1) above.entry = copies_.front().shift + *turn_of(above).spiral->from;
  return last;
}

absl::Status SpiralPlanner::Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
  (void)cancel, (void)layers;
  if (no_turns_nm_.empty()) return absl::OkStatus();
  plan.warnings.push_back(
      fmt::format("spiral_vase: {} of the {} layers above the bottom are not a single loop, the "
                  "first at z = {} mm; they are printed as ordinary layers",
                  no_turns_nm_.size(), hollow_, ToMm(static_cast<double>(no_turns_nm_.front()))));
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
