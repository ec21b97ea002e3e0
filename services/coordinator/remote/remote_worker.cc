#include "services/coordinator/remote/remote_worker.h"

#include <utility>

#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/fill_use_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kWorker[] = "worker";

absl::Status TakeTimes(const v1::WorkResponse& response, StageTimes* times) {
  absl::StatusOr<StageTimes> taken = FromProto(response.times());
  if (taken.ok()) *times = *taken;
  return taken.status();
}

absl::Status Take(v1::WorkResponse& response, FdmResult* result) {
  if (response.has_program())
    return Append(FromProto(std::move(*response.mutable_program())), &result->programs);
  if (response.has_warning()) return Append(FromProto(response.warning()), &result->warnings);
  if (response.has_fill()) return Append(FromProto(response.fill()), &result->fills);
  return TakeTimes(response, &result->times);
}

absl::Status Take(v1::WorkResponse& response, LaserResult* result) {
  if (response.has_exposed())
    return Append(FromProto(std::move(*response.mutable_exposed())), &result->programs);
  return TakeTimes(response, &result->times);
}

}  // namespace

template <typename Result>
absl::StatusOr<Result> RemoteWorker::Ask(const StageCall& call, const WorkStart& start,
                                         std::span<const SlicedLayer> layers) const {
  Result result;
  const auto write = [&](auto& stream) {
    v1::WorkRequest request;
    absl::Status status = ToProto(start, request.mutable_start());
    if (!status.ok() || !stream.Write(request)) return status;
    return WriteEach<v1::WorkRequest>(stream, layers,
                                      [](const SlicedLayer& layer, v1::WorkRequest* message) {
                                        return ToProto(layer, message->mutable_layer());
                                      });
  };
  const auto read = [&](auto& stream) {
    result = {};
    return ReadEach<v1::WorkResponse>(
        stream, [&](v1::WorkResponse& response) { return Take(response, &result); });
  };
  const absl::Status status =
      StreamOver(replicas_, options_.DeadlineFor(PointsIn(layers)), call, kWorker,
                 &v1::Worker::Stub::PrepareAsyncWorkRange, write, read);
  if (!status.ok()) return status;
  return result;
}

absl::StatusOr<FdmResult> RemoteWorker::Run(const StageCall& call, const FdmTask& task) const {
  const WorkStart start{call,
                        *task.settings,
                        task.range,
                        {task.plans.begin(), task.plans.end()},
                        {task.copies.begin(), task.copies.end()},
                        *task.facts};
  absl::StatusOr<FdmResult> result = Ask<FdmResult>(call, start, task.layers);
  if (!result.ok()) return result;
  if (absl::Status fits = CheckProgramsOfRange(result->programs, task.range); !fits.ok())
    return BadAnswer(kWorker, fits);
  return result;
}

absl::StatusOr<LaserResult> RemoteWorker::Run(const StageCall& call, const LaserTask& task) const {
  const WorkStart start{
      call, *task.settings, task.range, {}, {task.copies.begin(), task.copies.end()}, {}};
  absl::StatusOr<LaserResult> result = Ask<LaserResult>(call, start, task.layers);
  if (!result.ok()) return result;
  if (absl::Status fits = CheckLayersOfRange(result->programs, task.range); !fits.ok())
    return BadAnswer(kWorker, fits);
  return result;
}

absl::StatusOr<TaskResult> RemoteWorker::RunTask(const StageCall& call, const Task& task) const {
  const auto run = [&](const auto& of) -> absl::StatusOr<TaskResult> {
    auto result = Run(call, of);
    if (!result.ok()) return result.status();
    return *std::move(result);
  };
  return std::visit(run, task);
}

}  // namespace slicefarm::coordinator
