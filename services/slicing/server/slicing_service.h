#pragma once

#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/plates.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::slicing {

/// Translates slicefarm.v1.Slicing to a SlicingStage and an ArrangingStage and back.
class SlicingService final : public v1::Slicing::Service {
 public:
  /// The stages and `gate` must outlive the service. `threads`: what one call may use.
  SlicingService(const SlicingStage& slicing, const ArrangingStage& arranging, rpc::CallGate& gate,
                 int threads)
      : slicing_(slicing), arranging_(arranging), gate_(gate), threads_(threads) {}

  grpc::Status Slice(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::SliceResponse, v1::SliceRequest>* stream) override;
  grpc::Status PutOnPlates(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::PlatePlace, v1::SliceRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::SliceResponse, v1::SliceRequest>;
  using PlacesStream = rpc::ServerStream<v1::PlatePlace, v1::SliceRequest>;
  absl::Status SliceFiles(rpc::Call& call, Stream& stream) const;
  absl::Status ArrangeFiles(rpc::Call& call, PlacesStream& stream) const;
  static absl::Status Answer(const SlicedJob& job, Stream& stream);

  const SlicingStage& slicing_;
  const ArrangingStage& arranging_;
  rpc::CallGate& gate_;
  const int threads_;
};

}  // namespace slicefarm::slicing
