#include "services/coordinator/remote/remote_planning.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "common/stage/job_memory.h"
#include "common/stage/print_layers.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "slicefarm/v1/planning.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

struct PlanAnswer {
  JobPlan plan;
  bool ended = false;
  int64_t bytes = 0;  ///< memory of the plan, in bytes

  absl::Status Hold(const StageCall& call, int64_t more) {
    bytes += more;
    return HoldMemory(call, JobMemory::Kind::kPlan, bytes);
  }
};

absl::Status TakeEnd(const v1::PlanEnd& end, JobPlan& plan) {
  const absl::StatusOr<SeamQuality> seams = FromProto(end.seams());
  if (!seams.ok()) return seams.status();
  plan.seams = *seams;
  plan.notes.assign(end.notes().begin(), end.notes().end());
  plan.warnings.assign(end.warnings().begin(), end.warnings().end());
  for (const int64_t lift_nm : end.lifts_nm())
    if (absl::Status ok = CheckLift("lifts_nm", lift_nm); !ok.ok()) return ok;
  plan.lifts_nm.assign(end.lifts_nm().begin(), end.lifts_nm().end());
  return AllFromProto(end.copies(), "copies", &plan.copies);
}

absl::Status TakePlan(const StageCall& call, const v1::PlanResponse& response, PlanAnswer& answer) {
  JobPlan& plan = answer.plan;
  const auto hold = [&](absl::Status taken, auto& models) {
    return taken.ok() ? answer.Hold(call, MemoryOf(models.back())) : taken;
  };
  if (response.has_layer())
    return hold(Append(FromProto(response.layer()), &plan.layers), plan.layers);
  if (response.has_stack()) return Append(FromProto(response.stack()), &plan.stacks);
  if (response.has_section()) {
    if (plan.stacks.empty()) return Malformed("section", "is of no stack");
    std::vector<ObjectSection>& sections = plan.stacks.back().sections;
    return hold(Append(FromProto(response.section()), &sections), sections);
  }
  if (response.has_skirt()) {
    absl::StatusOr<Skirt> skirt = FromProto(response.skirt());
    if (!skirt.ok()) return skirt.status();
    plan.skirt = *std::move(skirt);
    return answer.Hold(call, MemoryOf(plan.skirt));
  }
  answer.ended = response.has_end();
  return TakeEnd(response.end(), plan);
}

absl::Status CheckPlan(const SlicedOutlines& job, const PlanAnswer& answer) {
  const JobPlan& plan = answer.plan;
  if (answer.ended && plan.copies.size() == job.copies.size() &&
      plan.layers.size() == PrintLayerCount(job.layers, plan.lifts_nm, plan.stacks))
    return absl::OkStatus();
  return Malformed("layer", "not a plan for each layer and copy");
}

}  // namespace

absl::StatusOr<JobPlan> RemotePlanning::Plan(const StageCall& call, const SlicedOutlines& job,
                                             const PlanningOptions& options) const {
  const PlanStart start{call,
                        options,
                        {job.copies.begin(), job.copies.end()},
                        {job.object_names.begin(), job.object_names.end()}};
  const auto write = [&](auto& stream) {
    absl::Status status = WriteStart<v1::PlanRequest>(stream, start);
    if (!status.ok()) return status;
    return WriteEach<v1::PlanRequest>(stream, job.layers,
                                      [](const SlicedLayer& layer, v1::PlanRequest* request) {
                                        return ToProto(layer, request->mutable_layer());
                                      });
  };
  auto answer = client_.Fitting(
      client_.Ask<PlanAnswer>(call, client_.options().DeadlineFor(PointsIn(job.layers)),
                              &v1::Planning::Stub::PrepareAsyncPlanJob, write,
                              [&](const v1::PlanResponse& response, PlanAnswer& taken) {
                                return TakePlan(call, response, taken);
                              }),
      [&](const PlanAnswer& planned) { return CheckPlan(job, planned); });
  if (!answer.ok()) return answer.status();
  return std::move(answer->plan);
}

}  // namespace slicefarm::coordinator
