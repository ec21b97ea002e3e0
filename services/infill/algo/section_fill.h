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
/// lines for each kind of area. `regions`: by row of the job's tables; each fill area has those of
/// its region. `fields`: of the same rows. `plan`: what is decided of the layer. `on_bed`: lines are as wide as the first layer's settings say. Errors: those
/// of CheckSpacing for the widths, and of CutLines.
absl::StatusOr<FilledSection> FillSection(WalledSection walled, bool on_bed,
                                          const ObjectLayers& objects,
                                          const LayerPlan& plan,
                                          std::span<const InfillOptions> regions,
                                          RegionFields& fields);

}  // namespace slicefarm::infill
