#include "services/planning/server/planning_service.h"

#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/rpc/server/limited_service.h"
#include "common/stage/memory_budget.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "services/planning/algo/job_planner.h"
#include "slicefarm/v1/planning.grpc.pb.h"

namespace slicefarm::planning {
namespace {

template <typename Stream>
absl::Status AnswerLayers(const std::vector<LayerPlan>& layers, Stream& stream) {
  return WriteEach<v1::PlanResponse>(stream, layers,
                                     [](const LayerPlan& layer, v1::PlanResponse* proto) {
                                       return ToProto(layer, proto->mutable_layer());
                                     });
}

/// Plans layers as they arrive and writes plans as they are finished.
template <typename Stream>
absl::Status PlanLayers(JobPlanner& planner, MemoryBudget::Share& memory, const CancelToken& cancel,
                        Stream& stream) {
  int32_t next = 0;
  return ReadEach<v1::PlanRequest>(stream, [&](const v1::PlanRequest& request) -> absl::Status {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    const absl::StatusOr<SlicedLayer> layer = FromProto(request.layer());
    if (!layer.ok()) return layer.status();
    if (layer->frame.index != next++) return Malformed("layer", "does not follow the one before");
    if (absl::Status planned = planner.Next(*layer); !planned.ok()) return planned;
    absl::Status held = memory.Hold(JobMemory::Kind::kOutlines, planner.HeldBytes());
    if (!held.ok()) return held;
    return AnswerLayers(planner.TakeFinished(), stream);
  });
}

/// Writes the stack, then its sections.
template <typename Stream>
absl::Status AnswerStack(const AddedStack& added, Stream& stream) {
  v1::PlanResponse head;
  if (absl::Status ok = ToProto(added, head.mutable_stack()); !ok.ok()) return ok;
  if (!stream.Write(head)) return absl::OkStatus();
  return WriteEach<v1::PlanResponse>(stream, added.sections,
                                     [](const ObjectSection& section, v1::PlanResponse* proto) {
                                       return ToProto(section, proto->mutable_section());
                                     });
}

template <typename Stream>
absl::Status AnswerRest(const JobPlan& plan, Stream& stream) {
  absl::Status status = AnswerLayers(plan.layers, stream);
  if (!status.ok()) return status;
  for (const AddedStack& added : plan.stacks)
    if (status = AnswerStack(added, stream); !status.ok()) return status;
  if (!plan.skirt.loops.empty()) {
    v1::PlanResponse skirt;
    status = ToProto(plan.skirt, skirt.mutable_skirt());
    if (!status.ok() || !stream.Write(skirt)) return status;
  }
  v1::PlanResponse end;
  end.mutable_end()->mutable_lifts_nm()->Assign(plan.lifts_nm.begin(), plan.lifts_nm.end());
  *end.mutable_end()->mutable_seams() = ToProto(plan.seams);
  end.mutable_end()->mutable_notes()->Assign(plan.notes.begin(), plan.notes.end());
  end.mutable_end()->mutable_warnings()->Assign(plan.warnings.begin(), plan.warnings.end());
  status = AllToProto(plan.copies, "copies", end.mutable_end()->mutable_copies());
  if (status.ok()) stream.Write(end);  // a client that is gone needs no error
  return status;
}

template <typename Stream>
absl::Status Plan(rpc::Call& call, Stream& stream, MemoryBudget& memory) {
  absl::StatusOr<PlanStart> start = ReadStart<v1::PlanRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  absl::StatusOr<JobPlanner> planner =
      JobPlanner::Make(start->options, start->copies, start->object_names);
  if (!planner.ok()) return planner.status();
  const auto held = memory.Take({}, call.job_id, 0, call.cancel);
  if (!held.ok()) return held.status();
  absl::Status status = PlanLayers(*planner, **held, call.cancel, stream);
  status.Update(call.cancel.Check());
  if (!status.ok()) return status;
  const absl::StatusOr<JobPlan> plan = planner->Finish(call.cancel);
  if (!plan.ok()) return plan.status();
  return AnswerRest(*plan, stream);
}

}  // namespace

std::unique_ptr<grpc::Service> MakePlanningService(rpc::CallLimiter& gate) {
  auto service = std::make_unique<rpc::LimitedService<v1::Planning>>(gate);
  const auto memory = std::make_shared<MemoryBudget>(DefaultMemoryBudget());
  service->Add("PlanJob", &v1::Planning::Service::PlanJob,
               [memory](rpc::Call& call, auto& stream) { return Plan(call, stream, *memory); });
  return service;
}

}  // namespace slicefarm::planning
