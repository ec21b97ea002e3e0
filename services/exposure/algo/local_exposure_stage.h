#pragma once

#include <memory>

#include "common/stage/exposure_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::exposure {

/// Scans each layer (expose_layer.h) and writes it (writers/writers.h); see README.md. Stateless.
/// A layer's result depends on the layers that its skins reach, so not on how a job is cut into
/// ranges. Errors: those of ExposeLayer.
std::unique_ptr<ExposureStage> MakeLocalExposure();

}  // namespace slicefarm::exposure
