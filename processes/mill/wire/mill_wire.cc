#include "processes/mill/wire/mill_wire.h"

#include <utility>

#include "common/wire/layers/program_wire.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/work_layers.h"
#include "processes/mill/task/mill_task.h"
#include "processes/mill/wire/mill_work.h"

namespace slicefarm {
namespace {

class ReceivedMill : public ReceivedTask {
 public:
  explicit ReceivedMill(MillTask task) : task_(std::move(task)) {}
  Task task() const override { return task_; }

 private:
  const MillTask task_;
};

absl::Status Take(v1::WorkResponse& response, MillResult* result) {
  if (response.has_milled()) return Append(FromProto(response.milled()), &result->steps);
  return TakeTimes(response, &result->times);
}

class WireOfMill : public TaskWire {
 public:
  bool IsIn(const v1::WorkStart& start) const override { return start.has_mill(); }

  /// Triangles have no outlines yet: each is cut about so often.
  int64_t PointsIn(const Task& task) const override {
    constexpr int64_t kPointsATriangle = 100;
    return kPointsATriangle * std::ssize(task.As<MillTask>().input->part.triangles);
  }

  absl::StatusOr<SharedParts> PartsOf(const Task& task) const override {
    return OnePart(task.As<MillTask>().input);
  }

  absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const override {
    const auto& mill = task.As<MillTask>();
    const auto& part = PartOf(mill.input);
    if (!part.ok()) return part.status();
    v1::WorkRequest start;
    *start.mutable_start()->mutable_call() = ToProto(call);
    const absl::Status put =
        ToProto(MillWork{mill.steps, mill.phase, mill.phase_first, mill.weight, (*part)->digest},
                start.mutable_start()->mutable_mill());
    if (put.ok()) end.Write(start);
    return put;
  }

  absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const override {
    MillResult result;
    const absl::Status read = ReadEach<v1::WorkResponse>(
        end, [&](v1::WorkResponse& response) { return Take(response, &result); });
    if (!read.ok()) return read;
    return TaskResult(std::move(result));
  }

  absl::Status Check(const Task& task, const TaskResult& result) const override {
    const int32_t want = task.As<MillTask>().steps.size();
    return std::ssize(result.As<MillResult>().steps) == want
               ? absl::OkStatus()
               : Malformed("milled", "not a step for each of the range");
  }

  absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                        SharedCache& shared,
                                                        const CancelToken& /*cancel*/,
                                                        WorkerEnd& /*end*/) const override {
    const absl::StatusOr<MillWork> work = FromProto(start.mill());
    if (!work.ok()) return Within("start", Within("mill", work.status()));
    absl::StatusOr<Shared<MillInput>> input =
        TakeShared<MillInput>(shared, work->shared, "start.mill.shared");
    if (!input.ok()) return input.status();
    return std::make_unique<ReceivedMill>(
        MillTask{work->steps, work->phase, work->phase_first, work->weight, *std::move(input)});
  }

  absl::Status SendResult(TaskResult task_result, WorkerEnd& end) const override {
    const auto& result = task_result.As<MillResult>();
    const absl::Status status = WriteEach<v1::WorkResponse>(
        end, result.steps, [](const MilledStep& step, v1::WorkResponse* proto) {
          return ToProto(step, proto->mutable_milled());
        });
    if (status.ok()) SendTimes(result.times, end);
    return status;
  }
};

}  // namespace

const TaskWire& MillWire() {
  static const WireOfMill wire;
  return wire;
}

}  // namespace slicefarm
