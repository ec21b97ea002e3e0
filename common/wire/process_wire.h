#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/shared_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/task_wire.h"

namespace slicefarm {

/// Reads the layers that follow the first message of a task: the layers of `range` and their halo.
/// `end`: the worker's end of the call.
inline absl::StatusOr<std::vector<SlicedLayer>> ReceiveLayers(LayerRange range,
                                                              const CancelToken& cancel,
                                                              WorkerEnd& end) {
  struct Start {
    StageCall call;
    LayerRange range;
  } start;
  start.call.cancel = cancel;
  start.range = range;
  return ReadNeighbourhood<v1::WorkRequest>(end, start);
}

/// TaskWire of a process, defined by the process's traits:
///
///   struct MillTraits {
///     using Task = MillTask;      // if it has `layers`, they follow the start
///     using Result = MillResult;  // has `times`, which are sent last
///     using Payload = MillTask;   // content of v1::WorkStart.work
///     static constexpr auto kWork = v1::WorkStart::kMill;
///     static constexpr auto kShared = &MillTask::input;  // sent to a worker once, with its digest
///     static int64_t PointsIn(const Task& task);         // see TaskWire
///     static absl::Status Put(const Task& task, v1::WorkStart* start);  // fills `work`
///     static absl::StatusOr<Payload> Take(const v1::WorkStart& start);
///     static Task TaskOf(const Payload& payload);  // without its layers and the shared value
///     static absl::Status SendParts(Result& result, WorkerEnd& end);
///     static absl::Status TakePart(v1::WorkResponse& response, Result* result);
///     static absl::Status Check(const Task& task, const Result& result);
///   };
template <typename Traits>
class ProcessWire : public TaskWire {
  using OneTask = typename Traits::Task;
  using Result = typename Traits::Result;
  using SharedValue = std::decay_t<decltype(*(std::declval<OneTask>().*Traits::kShared))>;
  static constexpr bool kHasLayers = requires(OneTask task) { task.layers; };

  struct Received : ReceivedTask {
    typename Traits::Payload payload;
    Shared<SharedValue> shared;
    std::vector<SlicedLayer> layers;

    slicefarm::Task task() const override {
      OneTask task = Traits::TaskOf(payload);
      task.*Traits::kShared = shared;
      if constexpr (kHasLayers) task.layers = layers;
      return task;
    }
  };

 public:
  bool IsIn(const v1::WorkStart& start) const override {
    return start.work_case() == Traits::kWork;
  }

  int64_t PointsIn(const Task& task) const override { return Traits::PointsIn(task.As<OneTask>()); }

  absl::StatusOr<SharedParts> PartsOf(const Task& task) const override {
    return OnePart(task.As<OneTask>().*Traits::kShared);
  }

  absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const override {
    const auto& one = task.As<OneTask>();
    const auto& part = PartOf(one.*Traits::kShared);
    if (!part.ok()) return part.status();
    v1::WorkRequest request;
    *request.mutable_start()->mutable_call() = ToProto(call);
    request.mutable_start()->set_shared((*part)->digest);
    absl::Status status = Traits::Put(one, request.mutable_start());
    if (!status.ok() || !end.Write(request)) return status;  // a peer that is gone says why
    if constexpr (kHasLayers)
      status = WriteEach<v1::WorkRequest>(end, one.layers,
                                          [](const SlicedLayer& layer, v1::WorkRequest* message) {
                                            return ToProto(layer, message->mutable_layer());
                                          });
    return status;
  }

  absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const override {
    Result result;
    const absl::Status read = ReadEach<v1::WorkResponse>(
        end, [&](v1::WorkResponse& response) { return Take(response, &result); });
    if (!read.ok()) return read;
    return TaskResult(std::move(result));
  }

  absl::Status Check(const Task& task, const TaskResult& result) const override {
    return Traits::Check(task.As<OneTask>(), result.As<Result>());
  }

  absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                        SharedCache& shared,
                                                        const CancelToken& cancel,
                                                        WorkerEnd& end) const override {
    auto payload = Traits::Take(start);
    if (!payload.ok()) return Within("start", Within(WorkName(), payload.status()));
    auto value = TakeShared<SharedValue>(shared, start.shared(), "start.shared");
    if (!value.ok()) return value.status();
    auto received = std::make_unique<Received>();
    received->payload = *std::move(payload);
    received->shared = *std::move(value);
    if constexpr (kHasLayers) {
      auto layers = ReceiveLayers(received->payload.range, cancel, end);
      if (!layers.ok()) return layers.status();
      received->layers = *std::move(layers);
    }
    return received;
  }

  absl::Status SendResult(TaskResult task_result, WorkerEnd& end) const override {
    auto& result = task_result.As<Result>();
    const absl::Status status = Traits::SendParts(result, end);
    if (!status.ok()) return status;
    v1::WorkResponse response;
    *response.mutable_times() = ToProto(result.times);
    end.Write(response);  // a client that is gone needs no error
    return status;
  }

 private:
  static const std::string& WorkName() {
    return v1::WorkStart::descriptor()->FindFieldByNumber(Traits::kWork)->name();
  }

  static absl::Status Take(v1::WorkResponse& response, Result* result) {
    if (!response.has_times()) return Traits::TakePart(response, result);
    const absl::StatusOr<StageTimes> times = FromProto(response.times());
    if (times.ok()) result->times = *times;
    return times.status();
  }
};

}  // namespace slicefarm
