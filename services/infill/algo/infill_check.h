#pragma once

#include "absl/status/status.h"
#include "common/model/options/flow_table.h"
#include "services/infill/algo/section_view.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Checks that the lines of all widths have a positive spacing. Otherwise their number would be
/// infinite. Errors: those of CheckSpacing.
absl::Status CheckWidths(const SectionView& view, const InfillOptions& options);

/// Checks the text of small_area_infill_flow_compensation_model. Errors: SETTING_MALFORMED.
absl::Status CheckFlows(const InfillOptions& options);

/// Returns the flow factors of short lines of solid infill. If the table is empty, all lines have
/// their full flow. REQUIRES: CheckFlows.
FlowTable FlowsOf(const InfillOptions& options);

}  // namespace slicefarm::infill
