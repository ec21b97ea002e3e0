#include "processes/fdm/wire/fdm_wire.h"

#include <utility>
#include <vector>

#include "common/stage/object_layers.h"
#include "common/wire/layers/fill_use_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/work_layers.h"
#include "processes/fdm/task/fdm_task.h"
#include "processes/fdm/wire/fdm_work.h"

namespace slicefarm {
namespace {

class ReceivedFdm : public ReceivedTask {
 public:
  ReceivedFdm(FdmWork work, Shared<FdmShared> job, std::vector<SlicedLayer> layers)
      : work_(std::move(work)), job_(std::move(job)), layers_(std::move(layers)) {}

  Task task() const override { return FdmTask{work_.range, layers_, work_.plans, job_}; }

 private:
  const FdmWork work_;
  const Shared<FdmShared> job_;
  const std::vector<SlicedLayer> layers_;
};

absl::Status Take(v1::WorkResponse& response, FdmResult* result) {
  if (response.has_program())
    return Append(FromProto(std::move(*response.mutable_program())), &result->programs);
  if (response.has_warning()) return Append(FromProto(response.warning()), &result->warnings);
  if (response.has_fill()) return Append(FromProto(response.fill()), &result->fills);
  return TakeTimes(response, &result->times);
}

class WireOfFdm : public TaskWire {
 public:
  bool IsIn(const v1::WorkStart& start) const override { return start.has_fdm(); }

  int64_t PointsIn(const Task& task) const override {
    return slicefarm::PointsIn(task.As<FdmTask>().layers);
  }

  absl::StatusOr<SharedParts> PartsOf(const Task& task) const override {
    return OnePart(task.As<FdmTask>().job);
  }

  absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const override {
    const auto& fdm = task.As<FdmTask>();
    const auto& part = PartOf(fdm.job);
    if (!part.ok()) return part.status();
    v1::WorkStart start;
    *start.mutable_call() = ToProto(call);
    const absl::Status status =
        ToProto(FdmWork{fdm.range, {fdm.plans.begin(), fdm.plans.end()}, (*part)->digest},
                start.mutable_fdm());
    return status.ok() ? SendWithLayers(start, fdm.layers, end) : status;
  }

  absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const override {
    FdmResult result;
    const absl::Status read = ReadEach<v1::WorkResponse>(
        end, [&](v1::WorkResponse& response) { return Take(response, &result); });
    if (!read.ok()) return read;
    return TaskResult(std::move(result));
  }

  absl::Status Check(const Task& task, const TaskResult& result) const override {
    return CheckProgramsOfRange(result.As<FdmResult>().programs, task.As<FdmTask>().range);
  }

  absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                        SharedCache& shared,
                                                        const CancelToken& cancel,
                                                        WorkerEnd& end) const override {
    absl::StatusOr<FdmWork> work = FromProto(start.fdm());
    if (!work.ok()) return Within("start", Within("fdm", work.status()));
    absl::StatusOr<Shared<FdmShared>> job =
        TakeShared<FdmShared>(shared, work->shared, "start.fdm.shared");
    if (!job.ok()) return job.status();
    absl::StatusOr<std::vector<SlicedLayer>> layers = ReceiveLayers(work->range, cancel, end);
    if (!layers.ok()) return layers.status();
    return std::make_unique<ReceivedFdm>(*std::move(work), *std::move(job), *std::move(layers));
  }

  absl::Status SendResult(TaskResult task_result, WorkerEnd& end) const override {
    auto& result = task_result.As<FdmResult>();
    absl::Status status = WriteEach<v1::WorkResponse>(
        end, result.programs, [](LayerProgram& program, v1::WorkResponse* proto) {
          return ToProto(std::move(program), proto->mutable_program());
        });
    if (!status.ok()) return status;
    status = WriteEach<v1::WorkResponse>(end, result.warnings,
                                         [](const LayerWarning& warning, v1::WorkResponse* proto) {
                                           *proto->mutable_warning() = ToProto(warning);
                                           return absl::OkStatus();
                                         });
    if (!status.ok()) return status;
    status = WriteEach<v1::WorkResponse>(end, result.fills,
                                         [](const FillUse& use, v1::WorkResponse* proto) {
                                           return ToProto(use, proto->mutable_fill());
                                         });
    if (status.ok()) SendTimes(result.times, end);
    return status;
  }
};

}  // namespace

const TaskWire& FdmWire() {
  static const WireOfFdm wire;
  return wire;
}

}  // namespace slicefarm
