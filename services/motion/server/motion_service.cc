#include "services/motion/server/motion_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/limited_service.h"
#include "common/stage/motion_job.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_answer.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/motion.grpc.pb.h"

namespace slicefarm::motion {
namespace {

template <typename Stream>
absl::Status Program(const MotionStage& stage, rpc::Call& call, Stream& stream,
                     SharedCache& shared) {
  const auto begun = BeginRange<MotionJob>(call, stream, shared);
  if (!begun.ok()) return begun.status();
  std::vector<OrderedLayer> layers;
  absl::Status status =
      ReadEach<v1::ProgramRequest>(stream, [&](const v1::ProgramRequest& request) {
        return AppendNext(FromProto(request.layer()), &layers);
      });
  status.Update(call.cancel.Check());
  status.Update(CheckLayersOfRange(layers, begun->start.range));
  if (!status.ok()) return status;
  return AnswerEach(stream, stage.Program(begun->start.call, std::move(layers), begun->job));
}

absl::Status Frame(const MotionStage& stage, rpc::Call& call,
                   const v1::ProgramEnvelopeRequest& request, v1::ProgramEnvelope* response) {
  absl::StatusOr<StageCall> stage_call = FromProto(request.call());
  if (!stage_call.ok()) return stage_call.status();
  const auto options = OptionsFromBytes<MotionOptions>(request.options());
  if (!options.ok()) return Within("options", options.status());
  const absl::StatusOr<ProgramSummary> summary = FromProto(request);
  if (!summary.ok()) return summary.status();
  call.job_id = stage_call->job_id;
  stage_call->cancel = call.cancel;
  absl::StatusOr<ProgramEnvelope> frame = stage.Envelope(*stage_call, *summary, *options);
  if (!frame.ok()) return frame.status();
  *response = ToProto(*std::move(frame));
  return absl::OkStatus();
}

}  // namespace

std::unique_ptr<grpc::Service> MakeMotionService(const MotionStage& stage, rpc::CallLimiter& gate,
                                                 SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Motion>>(gate);
  service->Add("ProgramLayers", &v1::Motion::Service::ProgramLayers,
               [&](rpc::Call& call, auto& stream) { return Program(stage, call, stream, shared); });
  service->Add("FrameProgram", &v1::Motion::Service::FrameProgram,
               [&](rpc::Call& call, const auto& request, v1::ProgramEnvelope* response) {
                 return Frame(stage, call, request, response);
               });
  return service;
}

}  // namespace slicefarm::motion
