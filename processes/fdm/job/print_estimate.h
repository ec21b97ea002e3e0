#pragma once

#include <span>
#include <vector>

#include "common/model/layers/layer.h"
#include "common/model/options/settings.h"
#include "common/stage/stages.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm {
struct FdmSettings;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// Estimated time and filament of one layer of the job, for all copies of all objects.
struct LayerEstimate {
  double time_s = 0;
  double volume_mm3 = 0;
};

/// Returns the estimates of EstimatePrint layer by layer.
std::vector<LayerEstimate> EstimateLayers(const SlicedOutlines& job, const FdmSettings& settings);

/// Estimates a print from the areas and outlines of its layers alone. The model has these rules:
/// - The walls along an outline are as wide as the number of walls times the width of a line.
/// - A layer has solid skin where it is larger than one of the layers near it, and sparse infill in
///   the rest.
/// - Lines are printed at their speed, with a full stop at each sharp corner.
/// - Each section uses the settings of its first region.
///
/// Cost: linear in the number of points; no stage runs. docs/figures/coordinator.md states the
/// error of the estimate.
JobEstimate EstimatePrint(const SlicedOutlines& job, const FdmSettings& settings);

}  // namespace slicefarm::coordinator
