#include "services/beading/server/beading_service.h"

#include <utility>
#include <vector>

#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"

namespace slicefarm::beading {

grpc::Status BeadingService::BeadLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::WalledLayer, v1::BeadRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "BeadLayers", [&](rpc::Call& call) { return Bead(call, buffered); });
}

absl::Status BeadingService::Bead(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<BeadStart> start = ReadStart<v1::BeadRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  call.layers = start->range;
  const absl::StatusOr<std::vector<SlicedLayer>> layers =
      ReadNeighbourhood<v1::BeadRequest>(stream, *start);
  if (!layers.ok()) return layers.status();

  const absl::StatusOr<std::vector<WalledLayer>> walled =
      stage_.Bead(start->call, {start->range, *layers}, start->options);
  if (!walled.ok()) return walled.status();
  return WriteEach<v1::WalledLayer>(
      stream, *walled,
      [](const WalledLayer& layer, v1::WalledLayer* proto) { return ToProto(layer, proto); });
}

}  // namespace slicefarm::beading
