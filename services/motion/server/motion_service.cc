#include "services/motion/server/motion_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/server_stream.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/motion.grpc.pb.h"

namespace slicefarm::motion {
namespace {

class MotionService final : public v1::Motion::Service {
 public:
  MotionService(const MotionStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status ProgramLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::LayerProgram, v1::ProgramRequest>* stream) override;

  grpc::Status FrameProgram(grpc::ServerContext* context, const v1::FrameRequest* request,
                            v1::ProgramFrame* response) override;

 private:
  using Stream = rpc::ServerStream<v1::LayerProgram, v1::ProgramRequest>;
  absl::Status Program(rpc::Call& call, Stream& stream) const;
  absl::Status Frame(rpc::Call& call, const v1::FrameRequest& request,
                     v1::ProgramFrame* response) const;

  const MotionStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status MotionService::ProgramLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::LayerProgram, v1::ProgramRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "ProgramLayers",
                   [&](rpc::Call& call) { return Program(call, buffered); });
}

absl::Status MotionService::Program(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<ProgramStart> start = ReadStart<v1::ProgramRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto job = TakeShared<MotionJob>(shared_, start->shared, "start.shared");
  if (!job.ok()) return job.status();
  call.job_id = start->call.job_id;
  std::vector<OrderedLayer> layers;
  absl::Status status =
      ReadEach<v1::ProgramRequest>(stream, [&](const v1::ProgramRequest& request) {
        return AppendNext(FromProto(request.layer()), &layers);
      });
  status.Update(call.cancel.Check());
  if (!status.ok()) return status;
  call.layers = RangeOf(layers);

  absl::StatusOr<std::vector<LayerProgram>> programs =
      stage_.Program(start->call, std::move(layers), *job);
  if (!programs.ok()) return programs.status();
  return WriteEach<v1::LayerProgram>(stream, *programs,
                                     [](LayerProgram& program, v1::LayerProgram* proto) {
                                       return ToProto(std::move(program), proto);
                                     });
}

grpc::Status MotionService::FrameProgram(grpc::ServerContext* context,
                                         const v1::FrameRequest* request,
                                         v1::ProgramFrame* response) {
  return gate_.Run(*context, "FrameProgram",
                   [&](rpc::Call& call) { return Frame(call, *request, response); });
}

absl::Status MotionService::Frame(rpc::Call& call, const v1::FrameRequest& request,
                                  v1::ProgramFrame* response) const {
  absl::StatusOr<StageCall> stage_call = FromProto(request.call());
  if (!stage_call.ok()) return stage_call.status();
  const auto options = OptionsFromBytes<MotionOptions>(request.options());
  if (!options.ok()) return Within("options", options.status());
  const absl::StatusOr<ProgramSummary> summary = FromProto(request);
  if (!summary.ok()) return summary.status();
  call.job_id = stage_call->job_id;
  stage_call->cancel = call.cancel;
  absl::StatusOr<ProgramEnvelope> frame = stage_.Envelope(*stage_call, *summary, *options);
  if (!frame.ok()) return frame.status();
  *response = ToProto(*std::move(frame));
  return absl::OkStatus();
}

std::unique_ptr<grpc::Service> MakeMotionService(const MotionStage& stage, rpc::CallGate& gate,
                                                 SharedCache& shared) {
  return std::make_unique<MotionService>(stage, gate, shared);
}

}  // namespace slicefarm::motion
