#include "services/coordinator/remote/remote_texture.h"

#include <optional>
#include <utility>

#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/engraving/texture_start_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/texture.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kTexture[] = "texture";

/// How long a call takes does not follow from the mesh alone: lines may be many and fine.
std::chrono::milliseconds TextureDeadline(const RemoteOptions& options, const SurfaceMesh& mesh) {
  constexpr int64_t kPointsATriangle = 400;
  return 4 * options.DeadlineFor(kPointsATriangle * std::ssize(mesh.triangles));
}

template <typename Stream>
absl::Status WriteTextureStart(Stream& stream, const TextureStart& start) {
  v1::TextureRequest request;
  absl::Status status = ToProto(start, request.mutable_start());
  if (status.ok()) stream.Write(request);  // that the peer is gone says the call
  return status;
}

/// Takes the one answer of a call.
template <typename Message, typename Model, typename Stream>
absl::Status ReadOne(Stream& stream, std::optional<Model>* model) {
  model->reset();
  return ReadEach<Message>(stream, [&](const Message& response) {
    absl::StatusOr<Model> taken = FromProto(response);
    if (taken.ok()) *model = *std::move(taken);
    return taken.status();
  });
}

}  // namespace

absl::StatusOr<MappedSurface> RemoteTexture::Map(const StageCall& call,
                                                 const Shared<SurfaceInput>& surface) const {
  const absl::StatusOr<SharedParts> parts = OnePart(surface);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::optional<MappedSurface> mapped;
  const absl::Status status = StreamOver(
      replicas, TextureDeadline(options_, surface->mesh), call, kTexture,
      &v1::Texture::Stub::PrepareAsyncMapSurface,
      [&](auto& stream) {
        return WriteTextureStart(stream, {call, parts->front()->digest});
      },
      [&](auto& stream) { return ReadOne<v1::MappedSurface>(stream, &mapped); });
  if (!status.ok()) return status;
  if (!mapped) return BadAnswer(kTexture, Malformed("map", "is missing"));
  return *std::move(mapped);
}

absl::StatusOr<EngraveLayout> RemoteTexture::LayOut(const StageCall& call,
                                                    const Shared<EngraveInput>& input) const {
  const absl::StatusOr<SharedParts> parts = OnePart(input);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::optional<EngraveLayout> layout;
  const absl::Status status = StreamOver(
      replicas, TextureDeadline(options_, input->surface.mesh), call, kTexture,
      &v1::Texture::Stub::PrepareAsyncLayOutLayers,
      [&](auto& stream) {
        return WriteTextureStart(stream, {call, parts->front()->digest});
      },
      [&](auto& stream) { return ReadOne<v1::EngraveLayout>(stream, &layout); });
  if (!status.ok()) return status;
  if (!layout) return BadAnswer(kTexture, Malformed("layout", "is missing"));
  return *std::move(layout);
}

absl::StatusOr<std::vector<EngravedLayer>> RemoteTexture::Engrave(const StageCall& call,
                                                                  const Shared<EngraveInput>& input,
                                                                  LayerRange range) const {
  const absl::StatusOr<SharedParts> parts = OnePart(input);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<EngravedLayer> layers;
  const absl::Status status = StreamOver(
      replicas, TextureDeadline(options_, input->surface.mesh), call, kTexture,
      &v1::Texture::Stub::PrepareAsyncEngraveLayers,
      [&](auto& stream) {
        return WriteTextureStart(stream, {call, parts->front()->digest, range});
      },
      [&](auto& stream) {
        layers.clear();
        return ReadEach<v1::EngravedPiece>(
            stream, [&](const v1::EngravedPiece& piece) { return TakePiece(piece, &layers); });
      });
  if (!status.ok()) return status;
  if (std::ssize(layers) != range.size())
    return BadAnswer(kTexture, Malformed("layer", "not one for each of the range"));
  return layers;
}

}  // namespace slicefarm::coordinator
