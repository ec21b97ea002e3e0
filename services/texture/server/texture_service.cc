#include "services/texture/server/texture_service.h"

#include "common/rpc/server/limited_service.h"
#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/stage_answer.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/texture.grpc.pb.h"

namespace slicefarm::texture {
namespace {

template <typename Stream>
absl::Status Engrave(const TextureStage& stage, rpc::Call& call, Stream& stream,
                     SharedCache& shared) {
  const auto begun = BeginRange<EngraveInput>(call, stream, shared);
  if (!begun.ok()) return begun.status();
  const auto layers = stage.Engrave(begun->start.call, begun->job, begun->start.range);
  if (!layers.ok()) return layers.status();
  for (const EngravedLayer& layer : *layers) {
    absl::Status sent =
        SendPieces(layer, [&](const v1::EngravedPiece& piece) { return stream.Write(piece); });
    if (!sent.ok()) return sent;
  }
  return absl::OkStatus();
}

}  // namespace

std::unique_ptr<grpc::Service> MakeTextureService(const TextureStage& stage, rpc::CallLimiter& gate,
                                                  SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Texture>>(gate);
  service->Add("MapSurface", &v1::Texture::Service::MapSurface,
               [&](rpc::Call& call, auto& stream) -> absl::Status {
                 const auto begun = BeginCall<SurfaceInput>(call, stream, shared);
                 if (!begun.ok()) return begun.status();
                 return AnswerOne(stream, stage.Map(begun->start.call, begun->job));
               });
  service->Add("LayOutLayers", &v1::Texture::Service::LayOutLayers,
               [&](rpc::Call& call, auto& stream) -> absl::Status {
                 const auto begun = BeginCall<EngraveInput>(call, stream, shared);
                 if (!begun.ok()) return begun.status();
                 return AnswerOne(stream, stage.LayOut(begun->start.call, begun->job));
               });
  service->Add("EngraveLayers", &v1::Texture::Service::EngraveLayers,
               [&](rpc::Call& call, auto& stream) { return Engrave(stage, call, stream, shared); });
  return service;
}

}  // namespace slicefarm::texture
