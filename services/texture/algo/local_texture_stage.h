#pragma once

#include <memory>

#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"

namespace slicefarm::texture {

/// Returns the texture stage that runs in this process; docs/algorithms/texture.md lists its steps.
/// Errors: the errors of MapSurface, PrepareEngraving, LayerPaths and EngraveProgram.
std::unique_ptr<TextureStage> MakeLocalTexture();

}  // namespace slicefarm::texture
