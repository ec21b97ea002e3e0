#include "services/texture/server/texture_service.h"

#include "common/rpc/server/server_stream.h"
#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/engraving/texture_start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/texture.grpc.pb.h"

namespace slicefarm::texture {
namespace {

class TextureService final : public v1::Texture::Service {
 public:
  TextureService(const TextureStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status MapSurface(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::MappedSurface, v1::TextureRequest>* stream) override;
  grpc::Status LayOutLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::EngraveLayout, v1::TextureRequest>* stream) override;
  grpc::Status EngraveLayers(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::EngravedPiece, v1::TextureRequest>* stream) override;

 private:
  using MapStream = rpc::ServerStream<v1::MappedSurface, v1::TextureRequest>;
  using LayoutStream = rpc::ServerStream<v1::EngraveLayout, v1::TextureRequest>;
  using PieceStream = rpc::ServerStream<v1::EngravedPiece, v1::TextureRequest>;
  absl::Status Map(rpc::Call& call, MapStream& stream) const;
  absl::Status LayOut(rpc::Call& call, LayoutStream& stream) const;
  absl::Status Engrave(rpc::Call& call, PieceStream& stream) const;

  const TextureStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

template <typename Message, typename Stream, typename Model>
absl::Status Answer(Stream& stream, const Model& model) {
  Message response;
  if (absl::Status put = ToProto(model, &response); !put.ok()) return put;
  stream.Write(response);  // that the client is gone is no error
  return absl::OkStatus();
}

}  // namespace

grpc::Status TextureService::MapSurface(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::MappedSurface, v1::TextureRequest>* stream) {
  MapStream buffered(*stream);
  return gate_.Run(*context, "MapSurface", [&](rpc::Call& call) { return Map(call, buffered); });
}

absl::Status TextureService::Map(rpc::Call& call, MapStream& stream) const {
  const absl::StatusOr<TextureStart> start = ReadStart<v1::TextureRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto surface = TakeShared<SurfaceInput>(shared_, start->shared, "start.shared");
  if (!surface.ok()) return surface.status();
  call.job_id = start->call.job_id;
  const auto mapped = stage_.Map(start->call, *surface);
  if (!mapped.ok()) return mapped.status();
  return Answer<v1::MappedSurface>(stream, *mapped);
}

grpc::Status TextureService::LayOutLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::EngraveLayout, v1::TextureRequest>* stream) {
  LayoutStream buffered(*stream);
  return gate_.Run(*context, "LayOutLayers",
                   [&](rpc::Call& call) { return LayOut(call, buffered); });
}

absl::Status TextureService::LayOut(rpc::Call& call, LayoutStream& stream) const {
  const absl::StatusOr<TextureStart> start = ReadStart<v1::TextureRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto input = TakeShared<EngraveInput>(shared_, start->shared, "start.shared");
  if (!input.ok()) return input.status();
  call.job_id = start->call.job_id;
  const auto layout = stage_.LayOut(start->call, *input);
  if (!layout.ok()) return layout.status();
  return Answer<v1::EngraveLayout>(stream, *layout);
}

grpc::Status TextureService::EngraveLayers(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::EngravedPiece, v1::TextureRequest>* stream) {
  PieceStream buffered(*stream);
  return gate_.Run(*context, "EngraveLayers",
                   [&](rpc::Call& call) { return Engrave(call, buffered); });
}

absl::Status TextureService::Engrave(rpc::Call& call, PieceStream& stream) const {
  const absl::StatusOr<TextureStart> start = ReadStart<v1::TextureRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto input = TakeShared<EngraveInput>(shared_, start->shared, "start.shared");
  if (!input.ok()) return input.status();
  call.job_id = start->call.job_id;
  call.about = {{"layer_first", start->range.first}, {"layer_last", start->range.last - 1}};
  const auto layers = stage_.Engrave(start->call, *input, start->range);
  if (!layers.ok()) return layers.status();
  for (const EngravedLayer& layer : *layers) {
    absl::Status sent = SendPieces(
        layer, [&](const v1::EngravedPiece& piece) { return stream.Write(piece); });
    if (!sent.ok()) return sent;
  }
  return absl::OkStatus();
}

std::unique_ptr<grpc::Service> MakeTextureService(const TextureStage& stage, rpc::CallGate& gate,
                                                  SharedCache& shared) {
  return std::make_unique<TextureService>(stage, gate, shared);
}

}  // namespace slicefarm::texture
