#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "slicefarm/v1/planning.grpc.pb.h"

namespace slicefarm::planning {

/// Translates slicefarm.v1.Planning to a JobPlanner and back. Layers are planned as they come and
/// their plans answered at once: what is kept is what the planners keep.
class PlanningService final : public v1::Planning::Service {
 public:
  /// `gate` must outlive the service.
  explicit PlanningService(rpc::CallGate& gate) : gate_(gate) {}

  grpc::Status PlanJob(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::PlanResponse, v1::PlanRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::PlanResponse, v1::PlanRequest>;
  static absl::Status Plan(rpc::Call& call, Stream& stream);

  rpc::CallGate& gate_;
};

}  // namespace slicefarm::planning
