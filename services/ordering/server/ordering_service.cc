#include "services/ordering/server/ordering_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/limited_service.h"
#include "common/stage/ordering_job.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/stage_answer.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/ordering.grpc.pb.h"

namespace slicefarm::ordering {
namespace {

template <typename Stream>
absl::Status Order(const OrderingStage& stage, rpc::Call& call, Stream& stream,
                   SharedCache& shared) {
  const auto begun = BeginRange<OrderingJob>(call, stream, shared);
  if (!begun.ok()) return begun.status();
  std::vector<FilledLayer> layers;
  std::vector<LayerPlan> plans;
  absl::Status status = ReadEach<v1::OrderRequest>(stream, [&](const v1::OrderRequest& request) {
    absl::Status appended = AppendNext(FromProto(request.layer().layer()), &layers);
    appended.Update(Append(FromProto(request.layer().plan()), &plans));
    return appended;
  });
  status.Update(call.cancel.Check());
  status.Update(CheckLayersOfRange(layers, begun->start.range));
  if (!status.ok()) return status;
  return AnswerEach(stream, stage.Order(begun->start.call, std::move(layers), plans, begun->job));
}

}  // namespace

std::unique_ptr<grpc::Service> MakeOrderingService(const OrderingStage& stage,
                                                   rpc::CallLimiter& gate, SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Ordering>>(gate);
  service->Add("OrderLayers", &v1::Ordering::Service::OrderLayers,
               [&](rpc::Call& call, auto& stream) { return Order(stage, call, stream, shared); });
  return service;
}

}  // namespace slicefarm::ordering
