#include "services/planning/algo/job_planner.h"

#include <utility>

#include "common/base/error.h"
#include "services/planning/algo/adhesion/adhesion_planner.h"
#include "services/planning/algo/seams/seam_planner.h"
#include "services/planning/algo/sequence/sequence_planner.h"
#include "services/planning/algo/travel/travel_planner.h"

namespace slicefarm::planning {
namespace {

absl::Status CheckObject(int32_t object, const PlanningOptions& options) {
  if (0 <= object && object < std::ssize(options.objects)) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "the plan's options do not name all objects", {{"field", "object"}});
}

absl::Status CheckRaft(const ObjectPlanOptions& object) {
  if (std::ssize(object.raft_settings) == object.raft.heights.layers) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "the rows of settings are not one for each layer of the raft",
                   {{"field", "raft_settings"}});
}

}  // namespace

JobPlanner::JobPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                       std::span<const std::string> object_names)
    : options_(&options), copies_(copies) {
  planners_.push_back(std::make_unique<SeamPlanner>(options));
  planners_.push_back(std::make_unique<TravelPlanner>(copies));
  if (options.sequence.complete_objects)
    planners_.push_back(std::make_unique<SequencePlanner>(options.sequence, copies, object_names));
  planners_.push_back(std::make_unique<AdhesionPlanner>(options, copies));
}

absl::StatusOr<JobPlanner> JobPlanner::Make(const PlanningOptions& options,
                                            std::span<const PlacedCopy> copies,
                                            std::span<const std::string> object_names) {
  for (const PlacedCopy& copy : copies)
    if (absl::Status ok = CheckObject(copy.object, options); !ok.ok()) return ok;
  for (const ObjectPlanOptions& object : options.objects)
    if (absl::Status ok = CheckRaft(object); !ok.ok()) return ok;
  return JobPlanner(options, copies, object_names);
}

absl::StatusOr<LayerPlan> JobPlanner::Next(const SlicedLayer& layer) {
  for (const ObjectSection& section : layer.sections)
    if (absl::Status ok = CheckObject(section.object, *options_); !ok.ok()) return ok;
  LayerPlan plan;
  for (const auto& planner : planners_) planner->Look(layer, plan);
  return plan;
}

absl::StatusOr<JobPlan> JobPlanner::Finish() {
  JobPlan plan;
  for (const PlacedCopy& copy : copies_) plan.copies.push_back({copy.object, copy.shift, 0});
  for (const auto& planner : planners_)
    if (absl::Status ok = planner->Finish(plan); !ok.ok()) return ok;
  return plan;
}

}  // namespace slicefarm::planning
