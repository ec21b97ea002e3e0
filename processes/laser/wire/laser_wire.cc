#include "processes/laser/wire/laser_wire.h"

#include <utility>
#include <vector>

#include "common/stage/object_layers.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/work_layers.h"
#include "processes/laser/task/laser_task.h"
#include "processes/laser/wire/laser_work.h"

namespace slicefarm {
namespace {

class ReceivedLaser : public ReceivedTask {
 public:
  ReceivedLaser(LayerRange range, Shared<ExposureJob> job, std::vector<SlicedLayer> layers)
      : range_(range), job_(std::move(job)), layers_(std::move(layers)) {}

  Task task() const override { return LaserTask{range_, layers_, job_}; }

 private:
  const LayerRange range_;
  const Shared<ExposureJob> job_;
  const std::vector<SlicedLayer> layers_;
};

absl::Status Take(v1::WorkResponse& response, LaserResult* result) {
  if (response.has_exposed())
    return Append(FromProto(std::move(*response.mutable_exposed())), &result->programs);
  return TakeTimes(response, &result->times);
}

class WireOfLaser : public TaskWire {
 public:
  bool IsIn(const v1::WorkStart& start) const override { return start.has_laser(); }

  int64_t PointsIn(const Task& task) const override {
    return slicefarm::PointsIn(task.As<LaserTask>().layers);
  }

  absl::StatusOr<SharedParts> PartsOf(const Task& task) const override {
    return OnePart(task.As<LaserTask>().job);
  }

  absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const override {
    const auto& laser = task.As<LaserTask>();
    const auto& part = PartOf(laser.job);
    if (!part.ok()) return part.status();
    v1::WorkStart start;
    *start.mutable_call() = ToProto(call);
    const absl::Status status =
        ToProto(LaserWork{laser.range, (*part)->digest}, start.mutable_laser());
    return status.ok() ? SendWithLayers(start, laser.layers, end) : status;
  }

  absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const override {
    LaserResult result;
    const absl::Status read = ReadEach<v1::WorkResponse>(
        end, [&](v1::WorkResponse& response) { return Take(response, &result); });
    if (!read.ok()) return read;
    return TaskResult(std::move(result));
  }

  absl::Status Check(const Task& task, const TaskResult& result) const override {
    return CheckLayersOfRange(result.As<LaserResult>().programs, task.As<LaserTask>().range);
  }

  absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                        SharedCache& shared,
                                                        const CancelToken& cancel,
                                                        WorkerEnd& end) const override {
    const absl::StatusOr<LaserWork> work = FromProto(start.laser());
    if (!work.ok()) return Within("start", Within("laser", work.status()));
    absl::StatusOr<Shared<ExposureJob>> job =
        TakeShared<ExposureJob>(shared, work->shared, "start.laser.shared");
    if (!job.ok()) return job.status();
    absl::StatusOr<std::vector<SlicedLayer>> layers = ReceiveLayers(work->range, cancel, end);
    if (!layers.ok()) return layers.status();
    return std::make_unique<ReceivedLaser>(work->range, *std::move(job), *std::move(layers));
  }

  absl::Status SendResult(TaskResult task_result, WorkerEnd& end) const override {
    auto& result = task_result.As<LaserResult>();
    const absl::Status status = WriteEach<v1::WorkResponse>(
        end, result.programs, [](ExposedProgram& program, v1::WorkResponse* proto) {
          return ToProto(std::move(program), proto->mutable_exposed());
        });
    if (status.ok()) SendTimes(result.times, end);
    return status;
  }
};

}  // namespace

const TaskWire& LaserWire() {
  static const WireOfLaser wire;
  return wire;
}

}  // namespace slicefarm
