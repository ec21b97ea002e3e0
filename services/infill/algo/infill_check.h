#pragma once

#include "absl/status/status.h"
#include "common/model/options/flow_table.h"
#include "services/infill/algo/section_view.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Checks that each infill width in `options` gives a positive spacing in the section's layer
/// height. With another spacing the number of lines would be infinite. Errors: SETTING_OUT_OF_RANGE
/// with the name of the width setting.
absl::Status CheckWidths(const SectionView& view, const InfillOptions& options);

/// Checks the text of small_area_infill_flow_compensation_model. Errors: SETTING_MALFORMED if it is
/// not a flow table.
absl::Status CheckFlows(const InfillOptions& options);

/// Returns flow factors of lines of solid infill by the length of the line. The table is empty if
/// the setting is off: all lines then have their full flow. REQUIRES: CheckFlows is OK.
FlowTable FlowsOf(const InfillOptions& options);

}  // namespace slicefarm::infill
