#include "common/wire/layers/fill_use_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "processes/fdm/task/layer_chain.h"
#include "processes/laser/task/laser_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

void Run(const WorkCall& given) {
  static const auto beading = beading::MakeLocalBeading();
  static const auto infill = infill::MakeLocalInfill();
  static const auto ordering = ordering::MakeLocalOrdering();
  static const auto motion = motion::MakeLocalMotion();
  static const LayerChain chain(*beading, *infill, *ordering, *motion);
  for (const v1::WorkRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.layer());
  }
  Requests<v1::WorkRequest> requests(given.requests());
  const auto start = ReadStart<v1::WorkRequest>(requests, WithDeadline());
  if (!start.ok()) return;
  const auto layers = ReadNeighbourhood<v1::WorkRequest>(requests, *start);
  if (!layers.ok()) return;
  if (start->settings.process == Process::kLaser) {
    static const auto exposure = exposure::MakeLocalExposure();
    LaserChain(*exposure)
        .Run(start->call, {start->range, *layers, start->copies, &start->settings})
        .IgnoreError();
    return;
  }
  const auto result = chain.Run(start->call, {start->range, *layers, start->plans, start->copies,
                                              &start->facts, &start->settings});
  if (!result.ok()) return;
  for (const LayerProgram& program : result->programs) {
    CheckGcode(program.gcode);
    CheckRoundTrip(Encoded<v1::LayerProgram>(program));
  }
  for (const LayerWarning& warning : result->warnings)
    CheckRoundTrip(Encoded<v1::LayerWarning>(warning));
  for (const FillUse& use : result->fills) CheckRoundTrip(Encoded<v1::FillUse>(use));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::WorkCall, slicefarm::fuzz::Run)
