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

/// What a layer of the job takes, of all copies of all objects.
struct LayerEstimate {
  double time_s = 0;
  double volume_mm3 = 0;
};

/// By layer, what EstimatePrint tells of all together.
std::vector<LayerEstimate> EstimateLayers(const SlicedOutlines& job, const FdmSettings& settings);

/// What a print will take, from the areas and outlines of its layers alone: walls as wide as they
/// are many, solid skins where a layer is larger than one near it, sparse infill in the rest; lines
/// at their speeds with a full stop at each sharp corner. Cost: linear in the points; no stage is
/// run. tests/bench/README.md says how far it is off.
/// Each section counts with the settings of its first region.
JobEstimate EstimatePrint(const SlicedOutlines& job, const FdmSettings& settings);

}  // namespace slicefarm::coordinator
