#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/task.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::worker {

/// Translates slicefarm.v1.Worker to a TaskRunner and back. The gate's slots are the worker's.
class WorkerService final : public v1::Worker::Service {
 public:
  /// `runner` and `gate` must outlive the service.
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

}  // namespace slicefarm::worker
