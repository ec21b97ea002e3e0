#include "services/infill/server/infill_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/server_stream.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/support/repeated_wire.h"
#include "slicefarm/v1/infill.grpc.pb.h"

namespace slicefarm::infill {
namespace {

class InfillService final : public v1::Infill::Service {
 public:
  InfillService(const InfillStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status FillLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::FilledLayer, v1::FillRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::FilledLayer, v1::FillRequest>;
  absl::Status Fill(rpc::Call& call, Stream& stream) const;

  const InfillStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status InfillService::FillLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::FilledLayer, v1::FillRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "FillLayers", [&](rpc::Call& call) { return Fill(call, buffered); });
}

absl::Status InfillService::Fill(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<FillStart> start = ReadStart<v1::FillRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto regions = TakeShared<InfillTable>(shared_, start->shared, "start.shared");
  if (!regions.ok()) return regions.status();
  call.job_id = start->call.job_id;
  call.layers = start->range;
  std::vector<SlicedLayer> neighbours;
  std::vector<WalledLayer> walled;
  std::vector<LayerPlan> plans;
  absl::Status status = ReadEach<v1::FillRequest>(stream, [&](const v1::FillRequest& request) {
    if (request.has_neighbour()) return AppendNext(FromProto(request.neighbour()), &neighbours);
    absl::Status taken = AppendNext(FromProto(request.layer().layer()), &walled);
    taken.Update(AllFromProto(request.layer().infill(), "infill", &plans.emplace_back().infill));
    taken.Update(CheckOrder(plans.back().infill));
    return taken;
  });
  status.Update(call.cancel.Check());
  status.Update(CheckNeighbourhood(neighbours, start->range));
  status.Update(CheckLayersOfRange(walled, start->range));
  if (!status.ok()) return status;

  const absl::StatusOr<std::vector<FilledLayer>> filled =
      stage_.Fill(start->call, std::move(walled), {start->range, neighbours}, plans, *regions);
  if (!filled.ok()) return filled.status();
  return WriteEach<v1::FilledLayer>(
      stream, *filled,
      [](const FilledLayer& layer, v1::FilledLayer* proto) { return ToProto(layer, proto); });
}

std::unique_ptr<grpc::Service> MakeInfillService(const InfillStage& stage, rpc::CallGate& gate,
                                                 SharedCache& shared) {
  return std::make_unique<InfillService>(stage, gate, shared);
}

}  // namespace slicefarm::infill
