#include <utility>

#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/start_wire.h"
#include "services/texture/algo/local_texture_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

/// Limit of layers. More layers and finer lines take long and find no more errors.
constexpr int32_t kMostLayers = 20;
constexpr size_t kMostTriangles = 200;

void MapGiven(const TextureStage& stage, const StageCall& call, const v1::SurfaceInput& given) {
  absl::StatusOr<SurfaceInput> surface = FromProto(given);
  if (!surface.ok() || surface->mesh.triangles.size() > kMostTriangles) return;
  const auto mapped = stage.Map(call, *std::move(surface));
  if (mapped.ok()) CheckRoundTrip(Encoded<v1::MappedSurface>(*mapped));
}

void Run(const TextureCall& given) {
  static const auto stage = texture::MakeLocalTexture();
  CheckRoundTrip(given.request().start());
  CheckRoundTrip(given.surface());
  CheckRoundTrip(given.shared());
  StageCall call;
  call.cancel = WithDeadline();
  MapGiven(*stage, call, given.surface());
  absl::StatusOr<EngraveInput> input = FromProto(given.shared());
  if (!input.ok() || input->surface.mesh.triangles.size() > kMostTriangles) return;
  const Shared<EngraveInput> shared(*std::move(input));
  const auto layout = stage->LayOut(call, shared);
  if (!layout.ok() || layout->layer_count > kMostLayers) return;
  CheckRoundTrip(Encoded<v1::EngraveLayout>(*layout));
  const auto layers = stage->Engrave(call, shared, {0, layout->layer_count});
  if (!layers.ok()) return;
  for (const EngravedLayer& layer : *layers)
    CheckRoundTrip(Encoded<v1::EngravedLayer>(EngravedLayer{layer.numbers, layer.program, {}}));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::TextureCall, slicefarm::fuzz::Run)
