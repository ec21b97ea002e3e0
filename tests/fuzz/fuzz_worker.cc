#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/layers/fill_stats_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "processes/fdm/wire/fdm_work.h"
#include "processes/list/tasks.h"
#include "processes/list/wire.h"
#include "processes/mill/wire/mill_work.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/texture/algo/local_texture_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

/// Connection of a client that sends and never reads.
class OneWay : public WorkerEnd {
 public:
  explicit OneWay(Requests<v1::WorkRequest>& requests) : requests_(requests) {}
  bool Read(v1::WorkRequest* message) override { return requests_.Read(message); }
  bool Write(const v1::WorkResponse&) override { return false; }

 private:
  Requests<v1::WorkRequest>& requests_;
};

ProcessRunners RunnersOver(const Stages& stages) {
  std::vector<std::shared_ptr<const TaskRunner>> runners;
  for (TaskChain& chain : ChainsOver(stages)) runners.push_back(std::move(chain.runner));
  return ProcessRunners(std::move(runners));
}

/// Stores shared data in the cache, and sets its digest in `start`.
template <typename Proto>
void Name(const Proto& proto, v1::WorkStart& start, SharedCache& cache) {
  CheckRoundTrip(proto);
  std::string bytes = proto.SerializeAsString();
  start.set_shared(SharedDigest(proto.GetTypeName(), bytes));
  cache.Put({proto.GetTypeName(), start.shared(), std::move(bytes)});
}

void Run(const WorkCall& given) {
  static const auto beading = beading::MakeLocalBeading();
  static const auto infill = infill::MakeLocalInfill();
  static const auto ordering = ordering::MakeLocalOrdering();
  static const auto motion = motion::MakeLocalMotion();
  static const auto exposure = exposure::MakeLocalExposure();
  static const auto milling = milling::MakeLocalMilling();
  static const auto texture = texture::MakeLocalTexture();
  static const ProcessRunners runners = RunnersOver({.beading = beading.get(),
                                                     .infill = infill.get(),
                                                     .ordering = ordering.get(),
                                                     .motion = motion.get(),
                                                     .exposure = exposure.get(),
                                                     .milling = milling.get(),
                                                     .texture = texture.get()});
  for (const v1::WorkRequest& request : given.requests()) {
    CheckRoundTrip(request.start().fdm());
    CheckRoundTrip(request.start().mill());
    CheckRoundTrip(request.layer());
  }
  Requests<v1::WorkRequest> requests(given.requests());
  OneWay end(requests);
  v1::WorkRequest first;
  if (!end.Read(&first)) return;
  SharedCache shared(0);
  if (first.start().has_fdm())
    Name(given.fdm(), *first.mutable_start(), shared);
  else if (first.start().has_laser())
    Name(given.laser(), *first.mutable_start(), shared);
  else if (first.start().has_mill())
    Name(given.mill(), *first.mutable_start(), shared);
  else if (first.start().has_engrave())
    Name(given.engrave(), *first.mutable_start(), shared);
  const TaskWire* wire = WireOf(first.start());
  if (wire == nullptr || !FromProto(first.start().call()).ok()) return;
  const CancelToken cancel = WithDeadline();
  const auto received = wire->Receive(first.start(), shared, cancel, end);
  if (!received.ok()) return;
  StageCall call;
  call.cancel = cancel;
  const Task task = (*received)->task();
  const auto made = runners.RunTask(call, task);
  if (!made.ok() || task.process() != Process::kFdm) return;
  const FdmResult* result = &made->As<FdmResult>();
  for (const LayerProgram& program : result->programs) {
    CheckGcode(program.gcode);
    CheckRoundTrip(Encoded<v1::LayerProgram>(program));
  }
  for (const LayerWarning& warning : result->warnings)
    CheckRoundTrip(Encoded<v1::LayerWarning>(warning));
  for (const FillStats& use : result->fills) CheckRoundTrip(Encoded<v1::FillStats>(use));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::WorkCall, slicefarm::fuzz::Run)
