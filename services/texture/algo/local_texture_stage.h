#pragma once

#include <memory>

#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"

namespace slicefarm::texture {

/// Returns the texture stage that runs in this program; README.md lists its steps. Errors: any
/// error of MapSurface, PrepareEngraving, LayerPaths and EngraveProgram.
std::unique_ptr<TextureStage> MakeLocalTexture();

}  // namespace slicefarm::texture
