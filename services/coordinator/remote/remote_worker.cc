#include "services/coordinator/remote/remote_worker.h"

#include <utility>

#include "processes/list/wire.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kWorker[] = "worker";

using Stream = rpc::StreamCall<v1::WorkRequest, v1::WorkResponse>;
using Channel = ChannelOf<v1::WorkResponse, v1::WorkRequest, Stream>;

}  // namespace

absl::StatusOr<TaskResult> RemoteWorker::RunTask(const StageCall& call, const Task& task) const {
  const TaskWire& wire = WireOf(task.process());
  TaskResult result;
  const auto write = [&](Stream& stream) {
    Channel end(stream);
    return wire.Send(call, task, end);
  };
  const auto read = [&](Stream& stream) {
    Channel end(stream);
    absl::StatusOr<TaskResult> received = wire.ReceiveResult(end);
    if (received.ok()) result = *std::move(received);
    return received.status();
  };
  const absl::StatusOr<SharedParts> parts = wire.PartsOf(task);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  const absl::Status status =
      StreamOver(replicas, options_.DeadlineFor(wire.PointsIn(task)), call, kWorker,
                 &v1::Worker::Stub::PrepareAsyncWorkRange, write, read);
  if (!status.ok()) return status;
  if (absl::Status fits = wire.Check(task, result); !fits.ok()) return BadAnswer(kWorker, fits);
  return result;
}

}  // namespace slicefarm::coordinator
