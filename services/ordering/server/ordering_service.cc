#include "services/ordering/server/ordering_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/server_stream.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/ordering.grpc.pb.h"

namespace slicefarm::ordering {
namespace {

class OrderingService final : public v1::Ordering::Service {
 public:
  OrderingService(const OrderingStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status OrderLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::OrderedLayer, v1::OrderRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::OrderedLayer, v1::OrderRequest>;
  absl::Status Order(rpc::Call& call, Stream& stream) const;

  const OrderingStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status OrderingService::OrderLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::OrderedLayer, v1::OrderRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "OrderLayers", [&](rpc::Call& call) { return Order(call, buffered); });
}

absl::Status OrderingService::Order(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<OrderStart> start = ReadStart<v1::OrderRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto job = TakeShared<OrderingJob>(shared_, start->shared, "start.shared");
  if (!job.ok()) return job.status();
  call.job_id = start->call.job_id;
  std::vector<FilledLayer> layers;
  std::vector<LayerPlan> plans;
  absl::Status status = ReadEach<v1::OrderRequest>(stream, [&](const v1::OrderRequest& request) {
    absl::Status appended = AppendNext(FromProto(request.layer().layer()), &layers);
    appended.Update(Append(FromProto(request.layer().plan()), &plans));
    return appended;
  });
  status.Update(call.cancel.Check());
  if (!status.ok()) return status;
  call.layers = RangeOf(layers);

  const absl::StatusOr<std::vector<OrderedLayer>> ordered =
      stage_.Order(start->call, std::move(layers), plans, *job);
  if (!ordered.ok()) return ordered.status();
  return WriteEach<v1::OrderedLayer>(
      stream, *ordered,
      [](const OrderedLayer& layer, v1::OrderedLayer* proto) { return ToProto(layer, proto); });
}

std::unique_ptr<grpc::Service> MakeOrderingService(const OrderingStage& stage, rpc::CallGate& gate,
                                                   SharedCache& shared) {
  return std::make_unique<OrderingService>(stage, gate, shared);
}

}  // namespace slicefarm::ordering
