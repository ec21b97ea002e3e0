#pragma once

#include <memory>

#include "common/stage/exposure_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::exposure {

/// Returns the exposure stage that runs in this program. The stage scans each layer
/// (expose_layer.h) and writes it (writers/writers.h); see README.md. Stateless. A layer's result
/// depends only on the layers that its skins reach, so that the division of a job into ranges does
/// not matter. Errors: see ExposeLayer.
std::unique_ptr<ExposureStage> MakeLocalExposure();

}  // namespace slicefarm::exposure
