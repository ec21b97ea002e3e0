#include "services/exposure/server/exposure_service.h"

#include <utility>

#include "common/rpc/server/limited_service.h"
#include "common/stage/exposure_job.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_answer.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/exposure.grpc.pb.h"

namespace slicefarm::exposure {
namespace {

absl::Status Frame(const ExposureStage& stage, rpc::Call& call,
                   const v1::ExposureEnvelopeRequest& request, v1::ExposureEnvelope* response) {
  absl::StatusOr<StageCall> stage_call = FromProto(request.call());
  if (!stage_call.ok()) return stage_call.status();
  const auto settings = OptionsFromBytes<ExposureSettings>(request.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  const absl::StatusOr<ExposureSummary> summary = FromProto(request);
  if (!summary.ok()) return summary.status();
  call.job_id = stage_call->job_id;
  stage_call->cancel = call.cancel;
  absl::StatusOr<ExposureEnvelope> frame = stage.Envelope(*stage_call, *summary, *settings);
  if (!frame.ok()) return frame.status();
  *response = ToProto(*std::move(frame));
  return absl::OkStatus();
}

}  // namespace

std::unique_ptr<grpc::Service> MakeExposureService(const ExposureStage& stage,
                                                   rpc::CallLimiter& gate, SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Exposure>>(gate);
  service->Add("ExposeLayers", &v1::Exposure::Service::ExposeLayers,
               [&](rpc::Call& call, auto& stream) -> absl::Status {
                 const auto begun = BeginRange<ExposureJob>(call, stream, shared);
                 if (!begun.ok()) return begun.status();
                 const auto& [start, job] = *begun;
                 const auto layers = ReadNeighbourhood<v1::ExposeRequest>(stream, start);
                 if (!layers.ok()) return layers.status();
                 return AnswerEach(stream, stage.Expose(start.call, {start.range, *layers}, job));
               });
  service->Add("FrameExposure", &v1::Exposure::Service::FrameExposure,
               [&](rpc::Call& call, const auto& request, v1::ExposureEnvelope* response) {
                 return Frame(stage, call, request, response);
               });
  return service;
}

}  // namespace slicefarm::exposure
