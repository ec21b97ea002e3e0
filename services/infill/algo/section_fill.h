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

/// Fills the islands of one section: divides fill areas into skins and sparse infill by the
/// object's neighbouring layers (skins.h), then lays out lines for each kind of area.
///
/// `on_bed`: true if the section is in the plate's first layer, with its line widths. `plan`:
/// decisions of planning for the layer. `regions`: options, indexed by Region::settings. `fields`:
/// fields with the same indices. Errors: SETTING_OUT_OF_RANGE for a width without positive spacing;
/// REQUEST_TOO_LARGE for too many lines (see CutLines).
absl::StatusOr<FilledSection> FillSection(WalledSection walled, bool on_bed,
                                          const ObjectLayers& objects, const LayerPlan& plan,
                                          std::span<const InfillOptions> regions,
                                          RegionFields& fields);

}  // namespace slicefarm::infill
