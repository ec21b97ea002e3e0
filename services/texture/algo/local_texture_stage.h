#pragma once

#include <memory>

#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"

namespace slicefarm::texture {

/// The texture stage in this process; README.md lists its steps. Errors: those of MapSurface,
/// PrepareEngraving, LayerPaths and EngraveProgram.
std::unique_ptr<TextureStage> MakeLocalTexture();

}  // namespace slicefarm::texture
