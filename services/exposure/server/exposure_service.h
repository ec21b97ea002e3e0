#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/exposure.grpc.pb.h"

namespace slicefarm::exposure {

/// Translates slicefarm.v1.Exposure to an ExposureStage and back.
class ExposureService final : public v1::Exposure::Service {
 public:
  /// `stage` and `gate` must outlive the service.
  ExposureService(const ExposureStage& stage, rpc::CallGate& gate) : stage_(stage), gate_(gate) {}

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
};

}  // namespace slicefarm::exposure
