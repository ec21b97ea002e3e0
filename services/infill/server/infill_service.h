#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/infill.grpc.pb.h"

namespace slicefarm::infill {

/// Translates slicefarm.v1.Infill to an InfillStage and back.
class InfillService final : public v1::Infill::Service {
 public:
  /// `stage` and `gate` must outlive the service.
  InfillService(const InfillStage& stage, rpc::CallGate& gate) : stage_(stage), gate_(gate) {}

  grpc::Status FillLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::FilledLayer, v1::FillRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::FilledLayer, v1::FillRequest>;
  absl::Status Fill(rpc::Call& call, Stream& stream) const;

  const InfillStage& stage_;
  rpc::CallGate& gate_;
};

}  // namespace slicefarm::infill
