#include <vector>

#include "common/stage/exposure_job.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

void Frame(const ExposureStage& stage, const v1::ExposureEnvelopeRequest& request) {
  const auto summary = FromProto(request);
  const auto settings = OptionsFromBytes<ExposureSettings>(request.settings());
  if (!summary.ok() || !settings.ok()) return;
  stage.Envelope({}, *summary, *settings).IgnoreError();
}

void Run(const ExposeCall& given) {
  static const auto stage = exposure::MakeLocalExposure();
  CheckRoundTrip(given.shared());
  for (const v1::ExposeRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.layer());
  }
  Frame(*stage, given.frame());
  Requests<v1::ExposeRequest> requests(given.requests());
  const auto start = ReadStart<v1::ExposeRequest>(requests, WithDeadline());
  const auto shared = FromProto(given.shared());
  if (!start.ok() || !shared.ok()) return;
  const auto layers = ReadNeighbourhood<v1::ExposeRequest>(requests, *start);
  if (!layers.ok()) return;
  const auto programs = stage->Expose(start->call, {start->range, *layers}, *shared);
  if (!programs.ok()) return;
  for (const ExposedProgram& program : *programs)
    CheckRoundTrip(Encoded<v1::ExposedProgram>(program));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::ExposeCall, slicefarm::fuzz::Run)
