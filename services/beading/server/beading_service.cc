#include "services/beading/server/beading_service.h"

#include "common/model/options/beading_options.h"
#include "common/rpc/server/limited_service.h"
#include "common/wire/stage_answer.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/beading.grpc.pb.h"

namespace slicefarm::beading {

std::unique_ptr<grpc::Service> MakeBeadingService(const BeadingStage& stage, rpc::CallLimiter& gate,
                                                  SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Beading>>(gate);
  service->Add("BeadLayers", &v1::Beading::Service::BeadLayers,
               [&](rpc::Call& call, auto& stream) -> absl::Status {
                 const auto begun = BeginRange<BeadingTable>(call, stream, shared);
                 if (!begun.ok()) return begun.status();
                 const auto& [start, regions] = *begun;
                 const auto layers = ReadNeighbourhood<v1::BeadRequest>(stream, start);
                 if (!layers.ok()) return layers.status();
                 return AnswerEach(stream, stage.Bead(start.call, {start.range, *layers}, regions));
               });
  return service;
}

}  // namespace slicefarm::beading
