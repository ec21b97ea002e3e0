#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/object_layers.h"
#include "processes/laser/model/exposed_layer.h"
#include "services/exposure/algo/exposure_report.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the vectors of one layer: contours, hatch or rings, skins and thin walls of each
/// section, once for all copies of its object. Also returns the order in which the copies are
/// scanned.
///
/// `objects`: for each object, the layer itself and ExposureOptions::Halo() layers above and below
/// it, as WithHalo returns them. `regions`: indexed by row of the job's tables. `copies`: the
/// copies of the whole job; copies of objects without a section in this layer are skipped.
///
/// The result depends only on these inputs, so that the division of a job into ranges does not
/// matter. Errors: Cancelled, checked a few times per section; REQUEST_MALFORMED (CheckRegions,
/// Decompose); REQUEST_TOO_LARGE (Hatch); INTERNAL (ExposeRegion).
absl::StatusOr<ExposedLayer> ExposeLayer(const SlicedLayer& layer, const ObjectLayers& objects,
                                         std::span<const ExposureOptions> regions,
                                         std::span<const Copy> copies, const CancelToken& cancel);

}  // namespace slicefarm::exposure
