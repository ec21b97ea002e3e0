#include "services/infill/algo/infill_check.h"

#include <fmt/core.h>

#include <string>

#include "common/base/error.h"
#include "common/model/bead_section.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {
namespace {

/// Returns the parsed table of the region. All callers share the result.
const absl::StatusOr<FlowTable>& FlowTableOf(const InfillOptions& options) {
  return options.small_area_flow_table.Once(
      [](const std::string& text) { return ParseFlowTable(text); });
}

}  // namespace

absl::Status CheckWidths(const SectionView& view, const InfillOptions& options) {
  if (view.on_bed) {
    return CheckSpacing("first_layer_extrusion_width", options.first_layer_width_nm,
                        view.height_nm);
  }
  absl::Status status =
      CheckSpacing("solid_infill_extrusion_width", options.solid_width_nm, view.height_nm);
  status.Update(CheckSpacing("top_infill_extrusion_width", options.top_width_nm, view.height_nm));
  if (options.density > 0 || !options.density_field.empty()) {
    status.Update(CheckSpacing("infill_extrusion_width", options.sparse_width_nm, view.height_nm));
  }
  return status;
}

absl::Status CheckFlows(const InfillOptions& options) {
  if (!options.small_area_flow) return absl::OkStatus();
  const auto& table = FlowTableOf(options);
  if (table.ok()) return absl::OkStatus();
  constexpr const char* kSetting = "small_area_infill_flow_compensation_model";
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{}: {}", kSetting, std::string(table.status().message())),
                   {{"setting", kSetting}});
}

FlowTable FlowsOf(const InfillOptions& options) {
  if (!options.small_area_flow) return {};
  return *FlowTableOf(options);
}

}  // namespace slicefarm::infill
