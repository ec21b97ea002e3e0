#include "services/beading/server/beading_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/server_stream.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/beading.grpc.pb.h"

namespace slicefarm::beading {
namespace {

class BeadingService final : public v1::Beading::Service {
 public:
  BeadingService(const BeadingStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status BeadLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::WalledLayer, v1::BeadRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::WalledLayer, v1::BeadRequest>;
  absl::Status Bead(rpc::Call& call, Stream& stream) const;

  const BeadingStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status BeadingService::BeadLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::WalledLayer, v1::BeadRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "BeadLayers", [&](rpc::Call& call) { return Bead(call, buffered); });
}

absl::Status BeadingService::Bead(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<BeadStart> start = ReadStart<v1::BeadRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto regions = TakeShared<BeadingTable>(shared_, start->shared, "start.shared");
  if (!regions.ok()) return regions.status();
  call.job_id = start->call.job_id;
  call.layers = start->range;
  const absl::StatusOr<std::vector<SlicedLayer>> layers =
      ReadNeighbourhood<v1::BeadRequest>(stream, *start);
  if (!layers.ok()) return layers.status();

  const absl::StatusOr<std::vector<WalledLayer>> walled =
      stage_.Bead(start->call, {start->range, *layers}, *regions);
  if (!walled.ok()) return walled.status();
  return WriteEach<v1::WalledLayer>(
      stream, *walled,
      [](const WalledLayer& layer, v1::WalledLayer* proto) { return ToProto(layer, proto); });
}

std::unique_ptr<grpc::Service> MakeBeadingService(const BeadingStage& stage, rpc::CallGate& gate,
                                                  SharedCache& shared) {
  return std::make_unique<BeadingService>(stage, gate, shared);
}

}  // namespace slicefarm::beading
