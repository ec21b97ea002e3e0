#include "services/coordinator/remote/remote_texture.h"

#include <optional>

#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/start_wire.h"
#include "slicefarm/v1/texture.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the deadline of a call. The mesh alone does not determine the time, because the lines
/// may be many and fine.
std::chrono::milliseconds TextureDeadline(const RemoteOptions& options, const SurfaceMesh& mesh) {
  constexpr int64_t kPointsATriangle = 400;
  return 4 * options.DeadlineFor(kPointsATriangle * std::ssize(mesh.triangles));
}

}  // namespace

absl::StatusOr<MappedSurface> RemoteTexture::Map(const StageCall& call,
                                                 const Shared<SurfaceInput>& surface) const {
  return client_.OnlyOne(client_.AskAbout<std::optional<MappedSurface>>(
      surface, StageStart{call, {}}, TextureDeadline(client_.options(), surface->mesh),
      &v1::Texture::Stub::PrepareAsyncMapSurface));
}

absl::StatusOr<EngraveLayout> RemoteTexture::LayOut(const StageCall& call,
                                                    const Shared<EngraveInput>& input) const {
  return client_.OnlyOne(client_.AskAbout<std::optional<EngraveLayout>>(
      input, StageStart{call, {}}, TextureDeadline(client_.options(), input->surface.mesh),
      &v1::Texture::Stub::PrepareAsyncLayOutLayers));
}

absl::StatusOr<std::vector<EngravedLayer>> RemoteTexture::Engrave(const StageCall& call,
                                                                  const Shared<EngraveInput>& input,
                                                                  LayerRange range) const {
  return client_.Fitting(
      client_.AskAbout<std::vector<EngravedLayer>>(
          input, StageStart{call, {}, range},
          TextureDeadline(client_.options(), input->surface.mesh),
          &v1::Texture::Stub::PrepareAsyncEngraveLayers, WriteNoMore(),
          [](const v1::EngravedPiece& piece, auto& layers) { return TakePiece(piece, &layers); }),
      [range](const auto& layers) {
        return std::ssize(layers) == range.size()
                   ? absl::OkStatus()
                   : Malformed("layer", "not one for each of the range");
      });
}

}  // namespace slicefarm::coordinator
