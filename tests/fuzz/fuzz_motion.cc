#include <vector>

#include "common/stage/motion_job.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "services/motion/algo/local_motion_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

const MotionStage& Stage() {
  static const auto stage = motion::MakeLocalMotion();
  return *stage;
}

void Program(const MotionCall& given) {
  Requests<v1::ProgramRequest> requests(given.requests());
  const auto start = ReadStart<v1::ProgramRequest>(requests, WithDeadline());
  const auto shared = FromProto(given.shared());
  if (!start.ok() || !shared.ok()) return;
  std::vector<OrderedLayer> layers;
  const absl::Status read =
      ReadEach<v1::ProgramRequest>(requests, [&](const v1::ProgramRequest& request) {
        return AppendNext(FromProto(request.layer()), &layers);
      });
  if (!read.ok()) return;
  const auto programs = Stage().Program(start->call, std::move(layers), *shared);
  if (!programs.ok()) return;
  for (const LayerProgram& program : *programs) {
    CheckGcode(program.gcode);
    CheckRoundTrip(Encoded<v1::LayerProgram>(program));
  }
}

void Frame(const v1::ProgramEnvelopeRequest& request) {
  CheckRoundTrip(request);
  const auto options = OptionsFromBytes<MotionOptions>(request.options());
  const auto summary = FromProto(request);
  if (!options.ok() || !summary.ok()) return;
  StageCall call;
  call.cancel = WithDeadline();
  const auto frame = Stage().Envelope(call, *summary, *options);
  if (!frame.ok()) return;
  CheckGcode(frame->prologue);
  CheckGcode(frame->epilogue);
  CheckGcode(frame->head);
  CheckGcode(frame->tail);
  CheckRoundTrip(Encoded<v1::ProgramEnvelope>(*frame));
}

void Run(const MotionCall& given) {
  CheckRoundTrip(given.shared());
  for (const v1::ProgramRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.layer());
  }
  Program(given);
  Frame(given.frame());
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::MotionCall, slicefarm::fuzz::Run)
