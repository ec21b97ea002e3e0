#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::slicing {

/// Translates slicefarm.v1.Slicing to a SlicingStage and back.
class SlicingService final : public v1::Slicing::Service {
 public:
  /// `stage` and `gate` must outlive the service. `threads`: what one call may use.
  SlicingService(const SlicingStage& stage, rpc::CallGate& gate, int threads)
      : stage_(stage), gate_(gate), threads_(threads) {}

  grpc::Status Slice(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::SliceResponse, v1::SliceRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::SliceResponse, v1::SliceRequest>;
  absl::Status SliceFiles(rpc::Call& call, Stream& stream) const;
  static absl::Status Answer(const SlicedJob& job, Stream& stream);

  const SlicingStage& stage_;
  rpc::CallGate& gate_;
  const int threads_;
};

}  // namespace slicefarm::slicing
