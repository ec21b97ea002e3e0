#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/beading.grpc.pb.h"

namespace slicefarm::beading {

/// Translates slicefarm.v1.Beading to a BeadingStage and back.
class BeadingService final : public v1::Beading::Service {
 public:
  /// `stage` and `gate` must outlive the service.
  BeadingService(const BeadingStage& stage, rpc::CallGate& gate) : stage_(stage), gate_(gate) {}

  grpc::Status BeadLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::WalledLayer, v1::BeadRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::WalledLayer, v1::BeadRequest>;
  absl::Status Bead(rpc::Call& call, Stream& stream) const;

  const BeadingStage& stage_;
  rpc::CallGate& gate_;
};

}  // namespace slicefarm::beading
