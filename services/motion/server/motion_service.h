#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/motion.grpc.pb.h"

namespace slicefarm::motion {

/// Translates slicefarm.v1.Motion to a MotionStage and back.
class MotionService final : public v1::Motion::Service {
 public:
  /// `stage` and `gate` must outlive the service.
  MotionService(const MotionStage& stage, rpc::CallGate& gate) : stage_(stage), gate_(gate) {}

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
};

}  // namespace slicefarm::motion
