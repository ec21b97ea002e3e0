#include "services/worker/server/worker_service.h"

#include <utility>
#include <vector>

#include "common/base/build_info.h"
#include "common/rpc/server/server_stream.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/fill_use_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::worker {
namespace {

class WorkerService final : public v1::Worker::Service {
 public:
  WorkerService(const TaskRunner& runner, rpc::CallGate& gate) : runner_(runner), gate_(gate) {}

  grpc::Status WorkRange(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::WorkResponse, v1::WorkRequest>* stream) override;
  grpc::Status GetWorkerInfo(grpc::ServerContext* context, const v1::GetWorkerInfoRequest* request,
                             v1::WorkerInfo* response) override;

 private:
  using Stream = rpc::ServerStream<v1::WorkResponse, v1::WorkRequest>;
  absl::Status Work(rpc::Call& call, Stream& stream) const;
  static absl::Status Answer(FdmResult result, Stream& stream);
  static absl::Status Answer(LaserResult result, Stream& stream);

  const TaskRunner& runner_;
  rpc::CallGate& gate_;
};

/// A range of the start's process. It points into its arguments.
Task TaskOf(const WorkStart& start, std::span<const SlicedLayer> layers) {
  switch (start.settings.process) {
    case Process::kFdm:
      return FdmTask{start.range, layers, start.plans, start.copies, &start.facts, &start.settings};
    case Process::kLaser:
      return LaserTask{start.range, layers, start.copies, &start.settings};
  }
  return {};
}

/// The last message. A client that is gone needs no error.
template <typename Stream>
void WriteTimes(const StageTimes& times, Stream& stream) {
  v1::WorkResponse response;
  *response.mutable_times() = ToProto(times);
  stream.Write(response);
}

}  // namespace

grpc::Status WorkerService::WorkRange(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::WorkResponse, v1::WorkRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "WorkRange", [&](rpc::Call& call) { return Work(call, buffered); });
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

absl::Status WorkerService::Work(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<WorkStart> start = ReadStart<v1::WorkRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  call.layers = start->range;
  const absl::StatusOr<std::vector<SlicedLayer>> layers =
      ReadNeighbourhood<v1::WorkRequest>(stream, *start);
  if (!layers.ok()) return layers.status();

  const Task task = TaskOf(*start, *layers);
  if (!runner_.processes().Has(ProcessOf(task)))
    return Malformed("start.settings.process", "is none of this worker's");
  absl::StatusOr<TaskResult> result = runner_.RunTask(start->call, task);
  if (!result.ok()) return result.status();
  return std::visit([&](auto&& of) { return Answer(std::move(of), stream); }, *std::move(result));
}

absl::Status WorkerService::Answer(FdmResult result, Stream& stream) {
  absl::Status status = WriteEach<v1::WorkResponse>(
      stream, result.programs, [](LayerProgram& program, v1::WorkResponse* proto) {
        return ToProto(std::move(program), proto->mutable_program());
      });
  if (!status.ok()) return status;
  status.Update(WriteEach<v1::WorkResponse>(
      stream, result.warnings, [](const LayerWarning& warning, v1::WorkResponse* proto) {
        *proto->mutable_warning() = ToProto(warning);
        return absl::OkStatus();
      }));
  if (!status.ok()) return status;
  status.Update(WriteEach<v1::WorkResponse>(stream, result.fills,
                                            [](const FillUse& use, v1::WorkResponse* proto) {
                                              return ToProto(use, proto->mutable_fill());
                                            }));
  if (!status.ok()) return status;
  WriteTimes(result.times, stream);
  return absl::OkStatus();
}

absl::Status WorkerService::Answer(LaserResult result, Stream& stream) {
  absl::Status status = WriteEach<v1::WorkResponse>(
      stream, result.programs, [](ExposedProgram& program, v1::WorkResponse* proto) {
        return ToProto(std::move(program), proto->mutable_exposed());
      });
  if (!status.ok()) return status;
  WriteTimes(result.times, stream);
  return absl::OkStatus();
}

std::unique_ptr<grpc::Service> MakeWorkerService(const TaskRunner& runner, rpc::CallGate& gate) {
  return std::make_unique<WorkerService>(runner, gate);
}

}  // namespace slicefarm::worker
