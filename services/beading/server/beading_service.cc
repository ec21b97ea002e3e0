#include "services/beading/server/beading_service.h"

#include <utility>
#include <vector>

#include "common/wire/layer_wire.h"
#include "common/wire/message_stream.h"
#include "common/wire/start_wire.h"

namespace slicefarm::beading {

grpc::Status BeadingService::BeadLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::WalledLayer, v1::BeadRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "BeadLayers", [&](rpc::Call& call) { return Bead(call, buffered); });
}

absl::Status BeadingService::Bead(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<BeadStart> start = ReadStart<v1::BeadRequest>(stream);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  call.layers = start->range;
  std::vector<SlicedLayer> layers;
  absl::Status status = ReadEach<v1::BeadRequest>(stream, [&](const v1::BeadRequest& request) {
    return Append(FromProto(request.layer()), &layers);
  });
  status.Update(call.cancel.Check());
  status.Update(CheckNeighbourhood(layers, start->range, start->layer_count));
  if (!status.ok()) return status;

  start->call.cancel = call.cancel;
  start->call.threads = threads_;
  const absl::StatusOr<std::vector<WalledLayer>> walled =
      stage_.Bead(start->call, {start->range, start->layer_count, layers}, start->options);
  if (!walled.ok()) return walled.status();
  return WriteEach<v1::WalledLayer>(
      stream, *walled,
      [](const WalledLayer& layer, v1::WalledLayer* proto) { return ToProto(layer, proto); });
}

}  // namespace slicefarm::beading
