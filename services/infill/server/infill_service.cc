#include "services/infill/server/infill_service.h"

#include <utility>
#include <vector>

#include "common/model/options/infill_options.h"
#include "common/rpc/server/limited_service.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/stage_answer.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "slicefarm/v1/infill.grpc.pb.h"

namespace slicefarm::infill {
namespace {

template <typename Stream>
absl::Status Fill(const InfillStage& stage, rpc::Call& call, Stream& stream, SharedCache& shared) {
  const auto begun = BeginRange<InfillTable>(call, stream, shared);
  if (!begun.ok()) return begun.status();
  const auto& [start, regions] = *begun;
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
  status.Update(CheckNeighbourhood(neighbours, start.range));
  status.Update(CheckLayersOfRange(walled, start.range));
  if (!status.ok()) return status;
  return AnswerEach(
      stream, stage.Fill(start.call, std::move(walled), {start.range, neighbours}, plans, regions));
}

}  // namespace

std::unique_ptr<grpc::Service> MakeInfillService(const InfillStage& stage, rpc::CallLimiter& gate,
                                                 SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Infill>>(gate);
  service->Add("FillLayers", &v1::Infill::Service::FillLayers,
               [&](rpc::Call& call, auto& stream) { return Fill(stage, call, stream, shared); });
  return service;
}

}  // namespace slicefarm::infill
