#include <utility>
#include <vector>

#include "common/model/options/infill_options.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "services/infill/algo/local_infill_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

void Run(const FillCall& given) {
  static const auto stage = infill::MakeLocalInfill();
  CheckRoundTrip(given.shared());
  for (const v1::FillRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.neighbour());
    CheckRoundTrip(request.layer().layer());
  }
  Requests<v1::FillRequest> requests(given.requests());
  const auto start = ReadStart<v1::FillRequest>(requests, WithDeadline());
  const auto shared = FromProto(given.shared());
  if (!start.ok() || !shared.ok()) return;
  std::vector<SlicedLayer> neighbours;
  std::vector<WalledLayer> walled;
  std::vector<LayerPlan> plans;
  absl::Status read = ReadEach<v1::FillRequest>(requests, [&](const v1::FillRequest& request) {
    if (request.has_neighbour()) return AppendNext(FromProto(request.neighbour()), &neighbours);
    absl::Status taken = AppendNext(FromProto(request.layer().layer()), &walled);
    taken.Update(AllFromProto(request.layer().infill(), "infill", &plans.emplace_back().infill));
    taken.Update(CheckOrder(plans.back().infill));
    return taken;
  });
  read.Update(CheckNeighbourhood(neighbours, start->range));
  read.Update(CheckLayersOfRange(walled, start->range));
  if (!read.ok()) return;
  const auto filled =
      stage->Fill(start->call, std::move(walled), {start->range, neighbours}, plans, *shared);
  if (!filled.ok()) return;
  for (const FilledLayer& layer : *filled) CheckRoundTrip(Encoded<v1::FilledLayer>(layer));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::FillCall, slicefarm::fuzz::Run)
