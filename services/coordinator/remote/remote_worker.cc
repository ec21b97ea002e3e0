#include "services/coordinator/remote/remote_worker.h"

#include <utility>

#include "common/wire/layer_wire.h"
#include "common/wire/message_stream.h"
#include "common/wire/program_wire.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kWorker[] = "worker";

template <typename Stream>
absl::Status WriteTask(Stream& stream, const StageCall& call, const RangeTask& task) {
  v1::WorkRequest request;
  const WorkStart start{call,
                        *task.settings,
                        task.range,
                        {task.plans.begin(), task.plans.end()},
                        {task.copies.begin(), task.copies.end()},
                        *task.facts};
  absl::Status status = ToProto(start, request.mutable_start());
  if (!status.ok() || !stream.Write(request)) return status;
  return WriteEach<v1::WorkRequest>(stream, task.layers,
                                    [](const SlicedLayer& layer, v1::WorkRequest* message) {
                                      return ToProto(layer, message->mutable_layer());
                                    });
}

absl::Status Take(v1::WorkResponse& response, RangeResult* result) {
  if (response.has_program()) {
    return Append(FromProto(std::move(*response.mutable_program())), &result->programs);
  }
  if (response.has_warning()) return Append(FromProto(response.warning()), &result->warnings);
  const absl::StatusOr<StageTimes> times = FromProto(response.times());
  if (times.ok()) result->times = *times;
  return times.status();
}

}  // namespace

absl::StatusOr<RangeResult> RemoteWorker::Run(const StageCall& call, const RangeTask& task) const {
  RangeResult result;
  const absl::Status status = StreamOver(
      replicas_, options_, call, kWorker, &v1::Worker::Stub::PrepareAsyncWorkRange,
      [&](auto& stream) { return WriteTask(stream, call, task); },
      [&](auto& stream) {
        result = {};
        return ReadEach<v1::WorkResponse>(
            stream, [&](v1::WorkResponse& response) { return Take(response, &result); });
      });
  if (!status.ok()) return status;
  if (absl::Status fits = CheckProgramsOfRange(result.programs, task.range); !fits.ok()) {
    return BadAnswer(kWorker, fits);
  }
  return result;
}

}  // namespace slicefarm::coordinator
