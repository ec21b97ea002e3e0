#include "services/planning/algo/job_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/stage/job_memory.h"
#include "common/stage/print_layers.h"
#include "services/planning/algo/adhesion/adhesion_planner.h"
#include "services/planning/algo/adhesion/raft_planner.h"
#include "services/planning/algo/air/air_planner.h"
#include "services/planning/algo/conflicts/conflict_planner.h"
#include "services/planning/algo/curl/curl_planner.h"
#include "services/planning/algo/infill/infill_planner.h"
#include "services/planning/algo/seams/seam_planner.h"
#include "services/planning/algo/sequence/sequence_planner.h"
#include "services/planning/algo/spiral/spiral_planner.h"
#include "services/planning/algo/supports/planner/supports_planner.h"
#include "services/planning/algo/travel/travel_planner.h"

namespace slicefarm::planning {
namespace {

absl::Status CheckObject(int32_t object, const PlanningOptions& options) {
  if (0 <= object && object < std::ssize(options.objects)) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "the plan's options do not name all objects", {{"field", "object"}});
}

absl::Status CheckSection(const ObjectSection& section, const PlanningOptions& options) {
  if (section.stack.IsPart()) return CheckObject(section.stack.object, options);
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "planning is told of parts alone", {{"field", "stack"}});
}

absl::Status CheckRaft(const ObjectPlanOptions& object) {
  if (std::ssize(object.raft_settings) == object.raft.heights.layers) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "the rows of settings are not one for each layer of the raft",
                   {{"field", "raft_settings"}});
}

/// Checks that all rafts have the same height if copies are printed one after the other. All rafts
/// are printed with the first copy, so the head would hit a higher raft of a later copy.
absl::Status CheckRaftsAreAlike(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                                std::span<const std::string> names) {
  if (!options.sequence.complete_objects || copies.empty()) return absl::OkStatus();
  const auto heights_of = [&](int32_t object) {
    return options.objects[static_cast<size_t>(object)].raft.heights;
  };
  const int32_t first = copies.front().object;
  for (const PlacedCopy& copy : copies) {
    if (heights_of(copy.object) == heights_of(first)) continue;
    const std::string a = NameOf(first, names), b = NameOf(copy.object, names);
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kObjectsCollide,
                     fmt::format("'{}' and '{}' cannot be printed one after the other: their rafts "
                                 "have different heights",
                                 a, b),
                     {{"first", a}, {"second", b}, {"rule", "raft"}});
  }
  return absl::OkStatus();
}

}  // namespace

JobPlanner::JobPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                       std::span<const std::string> object_names, int threads)
    : options_(&options), copies_(copies) {
  if (SupportsPlanner::IsNeeded(options, copies))
    region_planners_.push_back(
        std::make_unique<SupportsPlanner>(options, copies, object_names, threads));
  if (RaftPlanner::IsNeeded(options, copies))
    region_planners_.push_back(std::make_unique<RaftPlanner>(options, copies));
  planners_.push_back(std::make_unique<SeamPlanner>(options));
  planners_.push_back(std::make_unique<TravelPlanner>(copies));
  if (options.sequence.complete_objects)
    planners_.push_back(std::make_unique<SequencePlanner>(options.sequence, copies, object_names));
  if (SpiralPlanner::IsNeeded(options))
    planners_.push_back(std::make_unique<SpiralPlanner>(options, copies));
  if (options.avoid_curled || options.slow_curled)
    planners_.push_back(std::make_unique<CurlPlanner>(options));
  if (options.find_air) planners_.push_back(std::make_unique<AirPlanner>());
  planners_.push_back(std::make_unique<AdhesionPlanner>(options, copies));
  if (!options.objects_may_overlap)
    planners_.push_back(std::make_unique<ConflictPlanner>(options, copies, object_names));
  if (InfillPlanner::IsNeeded(options))
    planners_.push_back(std::make_unique<InfillPlanner>(options, object_names));
}

absl::StatusOr<JobPlanner> JobPlanner::Make(const PlanningOptions& options,
                                            std::span<const PlacedCopy> copies,
                                            std::span<const std::string> object_names,
                                            int threads) {
  for (const PlacedCopy& copy : copies)
    if (absl::Status ok = CheckObject(copy.object, options); !ok.ok()) return ok;
  for (const ObjectPlanOptions& object : options.objects)
    if (absl::Status ok = CheckRaft(object); !ok.ok()) return ok;
  if (absl::Status ok = SpiralPlanner::Check(options, copies); !ok.ok()) return ok;
  if (absl::Status ok = CheckRaftsAreAlike(options, copies, object_names); !ok.ok()) return ok;
  return JobPlanner(options, copies, object_names, threads);
}

absl::Status JobPlanner::Next(const SlicedLayer& layer) {
  for (const ObjectSection& section : layer.sections)
    if (absl::Status ok = CheckSection(section, *options_); !ok.ok()) return ok;
  if (region_planners_.empty()) {
    RegionPlan::AreasAboveSupports none;
    LookAt(layer, none);
  } else {
    parts_bytes_ += MemoryOf(layer);
    parts_.push_back(layer);
  }
  return absl::OkStatus();
}

void JobPlanner::LookAt(const SlicedLayer& layer, RegionPlan::AreasAboveSupports& above_supports) {
  LayerPlan& plan = layers_.Add();
  for (const ObjectSection& section : layer.sections) {
    if (!section.stack.IsPart()) continue;
    const auto found = above_supports.find({section.stack.object, section.layer});
    if (found == above_supports.end()) continue;
    PlanOf(section.stack.id, plan).above_supports = std::move(found->second);
  }
  for (const auto& planner : planners_) planner->Look(layer, plan);
  finished_ = layers_.end();
  for (const auto& planner : planners_) finished_ = std::min(finished_, planner->Revise(layers_));
}

absl::Status JobPlanner::PlanRegions(const CancelToken& cancel, JobPlan& plan) {
  RegionPlan regions{.next_id = static_cast<int32_t>(options_->objects.size()),
                     .lifts_nm = {},
                     .stacks = {},
                     .warnings = {},
                     .above_supports = {}};
  for (const auto& planner : region_planners_)
    if (absl::Status ok = planner->Plan(parts_, cancel, regions); !ok.ok()) return ok;
  plan.lifts_nm = std::move(regions.lifts_nm);
  plan.stacks = std::move(regions.stacks);
  plan.warnings = std::move(regions.warnings);
  const auto layers = PrintLayers(std::move(parts_), plan.lifts_nm, plan.stacks);
  if (std::ssize(layers) > limits::kMaxLayers)
    return LimitError(Reason::kRequestTooLarge, "layers of all objects, rafts and supports",
                      limits::kMaxLayers, std::ssize(layers));
  for (const SlicedLayer& layer : layers) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    LookAt(layer, regions.above_supports);
  }
  return absl::OkStatus();
}

int64_t JobPlanner::HeldBytes() const {
  int64_t bytes = parts_bytes_;
  for (const auto& planner : planners_) bytes += planner->HeldBytes();
  return bytes;
}

std::vector<LayerPlan> JobPlanner::TakeFinished() { return layers_.TakeBelow(finished_); }

absl::StatusOr<JobPlan> JobPlanner::Finish(const CancelToken& cancel) {
  JobPlan plan;
  for (const PlacedCopy& copy : copies_) plan.copies.push_back({copy.object, copy.shift, 0});
  if (!region_planners_.empty())
    if (absl::Status ok = PlanRegions(cancel, plan); !ok.ok()) return ok;
  for (const auto& planner : planners_)
    if (absl::Status ok = planner->Finish(cancel, layers_, plan); !ok.ok()) return ok;
  plan.layers = layers_.TakeBelow(layers_.end());
  return plan;
}

}  // namespace slicefarm::planning
