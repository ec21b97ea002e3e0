#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/object_layers.h"
#include "services/infill/algo/fields/region_fields.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Fills the islands of one section: skins from the object's neighbouring layers (skins.h), then
/// lines for each kind of area. `on_bed`: lines have the first layer's width. `plan`: decisions of
/// planning for the layer. `regions`: indexed by row of the job's tables; each fill area uses the
/// row of its region. `fields`: of the same rows. Errors: errors of CheckSpacing for the widths,
/// and of CutLines.
absl::StatusOr<FilledSection> FillSection(WalledSection walled, bool on_bed,
                                          const ObjectLayers& objects,
                                          const LayerPlan& plan,
                                          std::span<const InfillOptions> regions,
                                          RegionFields& fields);

}  // namespace slicefarm::infill
