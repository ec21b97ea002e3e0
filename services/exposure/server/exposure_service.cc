#include "services/exposure/server/exposure_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/server_stream.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/exposure.grpc.pb.h"

namespace slicefarm::exposure {
namespace {

class ExposureService final : public v1::Exposure::Service {
 public:
  ExposureService(const ExposureStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status ExposeLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::ExposedProgram, v1::ExposeRequest>* stream) override;
  grpc::Status FrameExposure(grpc::ServerContext* context, const v1::ExposureFrameRequest* request,
                             v1::ExposureFrame* response) override;

 private:
  using Stream = rpc::ServerStream<v1::ExposedProgram, v1::ExposeRequest>;
  absl::Status Expose(rpc::Call& call, Stream& stream) const;
  absl::Status Frame(rpc::Call& call, const v1::ExposureFrameRequest& request,
                     v1::ExposureFrame* response) const;

  const ExposureStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status ExposureService::ExposeLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::ExposedProgram, v1::ExposeRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "ExposeLayers",
                   [&](rpc::Call& call) { return Expose(call, buffered); });
}

absl::Status ExposureService::Expose(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<ExposeStart> start = ReadStart<v1::ExposeRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto job = TakeShared<ExposureJob>(shared_, start->shared, "start.shared");
  if (!job.ok()) return job.status();
  call.job_id = start->call.job_id;
  call.layers = start->range;
  const absl::StatusOr<std::vector<SlicedLayer>> layers =
      ReadNeighbourhood<v1::ExposeRequest>(stream, *start);
  if (!layers.ok()) return layers.status();
  absl::StatusOr<std::vector<ExposedProgram>> programs =
      stage_.Expose(start->call, {start->range, *layers}, *job);
  if (!programs.ok()) return programs.status();
  return WriteEach<v1::ExposedProgram>(stream, *programs,
                                       [](ExposedProgram& program, v1::ExposedProgram* proto) {
                                         return ToProto(std::move(program), proto);
                                       });
}

grpc::Status ExposureService::FrameExposure(grpc::ServerContext* context,
                                            const v1::ExposureFrameRequest* request,
                                            v1::ExposureFrame* response) {
  return gate_.Run(*context, "FrameExposure",
                   [&](rpc::Call& call) { return Frame(call, *request, response); });
}

absl::Status ExposureService::Frame(rpc::Call& call, const v1::ExposureFrameRequest& request,
                                    v1::ExposureFrame* response) const {
  absl::StatusOr<StageCall> stage_call = FromProto(request.call());
  if (!stage_call.ok()) return stage_call.status();
  const auto settings = OptionsFromBytes<ExposureSettings>(request.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  const absl::StatusOr<ExposureSummary> summary = FromProto(request);
  if (!summary.ok()) return summary.status();
  call.job_id = stage_call->job_id;
  stage_call->cancel = call.cancel;
  absl::StatusOr<ExposureEnvelope> frame = stage_.Envelope(*stage_call, *summary, *settings);
  if (!frame.ok()) return frame.status();
  *response = ToProto(*std::move(frame));
  return absl::OkStatus();
}

std::unique_ptr<grpc::Service> MakeExposureService(const ExposureStage& stage, rpc::CallGate& gate,
                                                   SharedCache& shared) {
  return std::make_unique<ExposureService>(stage, gate, shared);
}

}  // namespace slicefarm::exposure
