#include "services/worker/server/worker_service.h"

#include <utility>
#include <vector>

#include "common/base/build_info.h"
#include "common/wire/message_stream.h"
#include "common/wire/program_wire.h"
#include "common/wire/start_wire.h"

namespace slicefarm::worker {

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

  absl::StatusOr<RangeResult> result = runner_.Run(
      start->call, {start->range, *layers, start->plans, start->copies, &start->facts,
                    &start->settings});
  if (!result.ok()) return result.status();
  return Answer(*std::move(result), stream);
}

absl::Status WorkerService::Answer(RangeResult result, Stream& stream) {
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
  v1::WorkResponse times;
  *times.mutable_times() = ToProto(result.times);
  stream.Write(times);  // a client that is gone needs no error
  return absl::OkStatus();
}

}  // namespace slicefarm::worker
