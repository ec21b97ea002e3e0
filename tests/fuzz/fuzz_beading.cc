#include "common/model/options/beading_options.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "services/beading/algo/local_beading_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

void Run(const BeadCall& given) {
  static const auto stage = beading::MakeLocalBeading();
  CheckRoundTrip(given.shared());
  for (const v1::BeadRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.layer());
  }
  Requests<v1::BeadRequest> requests(given.requests());
  const auto start = ReadStart<v1::BeadRequest>(requests, WithDeadline());
  const auto shared = FromProto(given.shared());
  if (!start.ok() || !shared.ok()) return;
  const auto layers = ReadNeighbourhood<v1::BeadRequest>(requests, *start);
  if (!layers.ok()) return;
  const auto walled = stage->Bead(start->call, {start->range, *layers}, *shared);
  if (!walled.ok()) return;
  for (const WalledLayer& layer : *walled) CheckRoundTrip(Encoded<v1::WalledLayer>(layer));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::BeadCall, slicefarm::fuzz::Run)
