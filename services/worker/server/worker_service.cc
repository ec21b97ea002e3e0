#include "services/worker/server/worker_service.h"

#include <string>
#include <utility>

#include "common/base/build_info.h"
#include "common/rpc/server/server_stream.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"
#include "processes/list/wire.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::worker {
namespace {

class WorkerService final : public v1::Worker::Service {
 public:
  WorkerService(const TaskRunner& runner, rpc::CallLimiter& gate, SharedCache& shared)
      : runner_(runner), gate_(gate), shared_(shared) {}

  grpc::Status WorkRange(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::WorkResponse, v1::WorkRequest>* stream) override;
  grpc::Status GetWorkerInfo(grpc::ServerContext* context, const v1::GetWorkerInfoRequest* request,
                             v1::WorkerInfo* response) override;

 private:
  absl::Status Work(rpc::Call& call, WorkerEnd& end) const;

  const TaskRunner& runner_;
  rpc::CallLimiter& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status WorkerService::WorkRange(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::WorkResponse, v1::WorkRequest>* stream) {
  using Stream = rpc::ServerStream<v1::WorkResponse, v1::WorkRequest>;
  Stream buffered(*stream);
  ChannelOf<v1::WorkRequest, v1::WorkResponse, Stream> end(buffered);
  return gate_.Run(*context, "WorkRange", [&](rpc::Call& call) { return Work(call, end); });
}

grpc::Status WorkerService::GetWorkerInfo(grpc::ServerContext* /*context*/,
                                          const v1::GetWorkerInfoRequest* /*request*/,
                                          v1::WorkerInfo* response) {
  response->set_build_id(std::string(BuildId()));
  response->set_slots(gate_.admission().slots());
  for (const ProcessInfo& info : kProcesses)
    if (runner_.processes().Has(info.process))
      response->add_processes(EnumToProto<v1::Process>(info.process));
  return grpc::Status::OK;
}

absl::Status WorkerService::Work(rpc::Call& call, WorkerEnd& end) const {
  v1::WorkRequest first;
  if (!end.Read(&first) || !first.has_start()) return Malformed("start", "does not come first");
  absl::StatusOr<StageCall> stage_call = FromProto(first.start().call());
  if (!stage_call.ok()) return Within("start", stage_call.status());
  stage_call->cancel = call.cancel;
  call.job_id = stage_call->job_id;
  const TaskWire* wire = WireOf(first.start());
  if (wire == nullptr) return Malformed("start.work", "is missing");
  const auto received = wire->Receive(first.start(), shared_, call.cancel, end);
  if (!received.ok()) return received.status();

  const Task task = (*received)->task();
  for (const auto& [name, number] : task.label().numbers) call.about.push_back({name, number});
  if (!runner_.processes().Has(task.process()))
    return Malformed("start.work", "is of none of this worker's processes");
  absl::StatusOr<TaskResult> result = runner_.RunTask(*stage_call, task);
  if (!result.ok()) return result.status();
  return wire->SendResult(*std::move(result), end);
}

std::unique_ptr<grpc::Service> MakeWorkerService(const TaskRunner& runner, rpc::CallLimiter& gate,
                                                 SharedCache& shared) {
  return std::make_unique<WorkerService>(runner, gate, shared);
}

}  // namespace slicefarm::worker
