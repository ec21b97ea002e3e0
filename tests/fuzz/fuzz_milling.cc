#include <utility>
#include <vector>

#include "common/wire/layers/message_stream.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/mill_start_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "services/milling/algo/local_milling_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

/// Limit of steps. More steps take long and find no more errors.
constexpr size_t kMostSteps = 60;

void Run(const MillCall& given) {
  static const auto stage = milling::MakeLocalMilling();
  CheckRoundTrip(given.shared());
  for (const v1::MillRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.step());
  }
  Requests<v1::MillRequest> requests(given.requests());
  auto start = ReadStart<v1::MillRequest>(requests, WithDeadline());
  absl::StatusOr<MillInput> input = FromProto(given.shared());
  if (!start.ok() || !input.ok()) return;
  const Shared<MillInput> shared(*std::move(input));
  const auto layout = stage->LayOut(start->call, shared);
  if (!layout.ok() || layout->steps.size() > kMostSteps) return;
  CheckRoundTrip(Encoded<v1::MillLayout>(*layout));
  const auto count = static_cast<int32_t>(layout->steps.size());
  auto steps = stage->Mill(start->call, shared, {0, count});
  if (!steps.ok()) return;
  for (const MilledStep& step : *steps) CheckRoundTrip(Encoded<v1::MilledStep>(step));
  const auto program =
      stage->Assemble(start->call, shared, *std::move(steps), start->settings_text);
  if (program.ok()) CheckRoundTrip(Encoded<v1::MillReport>(program->report));
  // Steps of another client that claims them to be part of the job.
  std::vector<MilledStep> claimed;
  v1::MillRequest request;
  while (requests.Read(&request))
    if (auto step = FromProto(request.step()); step.ok()) claimed.push_back(*std::move(step));
  stage->Assemble(start->call, shared, std::move(claimed), "").IgnoreError();
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::MillCall, slicefarm::fuzz::Run)
