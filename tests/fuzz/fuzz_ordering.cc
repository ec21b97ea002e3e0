#include <vector>

#include "common/stage/ordering_job.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

void Run(const OrderCall& given) {
  static const auto stage = ordering::MakeLocalOrdering();
  CheckRoundTrip(given.shared());
  for (const v1::OrderRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.layer().layer());
    CheckRoundTrip(request.layer().plan());
  }
  Requests<v1::OrderRequest> requests(given.requests());
  const auto start = ReadStart<v1::OrderRequest>(requests, WithDeadline());
  const auto shared = FromProto(given.shared());
  if (!start.ok() || !shared.ok()) return;
  std::vector<FilledLayer> layers;
  std::vector<LayerPlan> plans;
  const absl::Status read =
      ReadEach<v1::OrderRequest>(requests, [&](const v1::OrderRequest& request) {
        absl::Status appended = AppendNext(FromProto(request.layer().layer()), &layers);
        appended.Update(Append(FromProto(request.layer().plan()), &plans));
        return appended;
      });
  if (!read.ok()) return;
  const auto ordered = stage->Order(start->call, std::move(layers), plans, *shared);
  if (!ordered.ok()) return;
  for (const OrderedLayer& layer : *ordered) CheckRoundTrip(Encoded<v1::OrderedLayer>(layer));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::OrderCall, slicefarm::fuzz::Run)
