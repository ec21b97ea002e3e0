#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/ordering.grpc.pb.h"

namespace slicefarm::ordering {

/// Translates slicefarm.v1.Ordering to an OrderingStage and back.
class OrderingService final : public v1::Ordering::Service {
 public:
  /// `stage` and `gate` must outlive the service.
  OrderingService(const OrderingStage& stage, rpc::CallGate& gate) : stage_(stage), gate_(gate) {}

  grpc::Status OrderLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::OrderedLayer, v1::OrderRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::OrderedLayer, v1::OrderRequest>;
  absl::Status Order(rpc::Call& call, Stream& stream) const;

  const OrderingStage& stage_;
  rpc::CallGate& gate_;
};

}  // namespace slicefarm::ordering
