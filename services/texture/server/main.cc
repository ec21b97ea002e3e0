#include "common/rpc/server/serve.h"
#include "services/texture/algo/local_texture_stage.h"
#include "services/texture/server/texture_service.h"

int main(int argc, char** argv) {
  const auto stage = slicefarm::texture::MakeLocalTexture();
  return slicefarm::rpc::ServeSharingStage(
      argc, argv, "texture", "maps textures onto curved surfaces", [&](auto& gate, auto& shared) {
        return slicefarm::texture::MakeTextureService(*stage, gate, shared);
      });
}
