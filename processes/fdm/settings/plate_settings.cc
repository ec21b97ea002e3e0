#include "processes/fdm/settings/plate_settings.h"

#include <algorithm>

#include "common/model/options/adhesion_options.h"
#include "common/model/options/planning_options.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/adhesion_rows.h"
#include "processes/fdm/settings/support_rows.h"

namespace slicefarm::config::fdm {
namespace {

/// Returns the distance from an object to the outer edge of its brim. Returns 0 for auto_brim,
/// because its width depends on the shape.
Coord BrimReach(const ObjectPlanOptions& object) {
  const BrimOptions& brim = object.brim;
  const bool outside = brim.type == BrimType::kOuterOnly || brim.type == BrimType::kOuterAndInner ||
                       brim.type == BrimType::kEars;
  if (!outside || brim.automatic.on || object.raft.heights.layers > 0 || brim.width_nm <= 0)
    return 0;
  return brim.separation_nm + (brim.compensated ? 0 : brim.foot_nm) + brim.width_nm;
}

/// Sets the distance of arranged copies: duplicate_distance between the edges of their brims.
void LeaveRoomForBrims(JobSettings& plate) {
  Coord reach = 0;
  for (const ObjectRow& object : FdmOf(plate).objects) reach = std::max(reach, BrimReach(object));
  SlicingOptions& slicing = plate.slicing;
  if (reach > 0)
    slicing.clearance_radius_nm =
        std::max(slicing.clearance_radius_nm, slicing.part_distance_nm + 2 * reach);
}

absl::Status AddSupportRows(JobRows& object, RegionRows& rows) {
  ObjectRow& planning = FdmOf(object).object;
  if (!planning.support.on) return absl::OkStatus();
  for (int32_t i = 0; i < kSupportRowCount; ++i) {
    absl::StatusOr<int32_t> row = rows.RowOf(SupportRegionRow(object, static_cast<SupportRow>(i)));
    if (!row.ok()) return row.status();
    planning.support_settings[static_cast<size_t>(i)] = *row;
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status AddAdhesionRows(JobRows& object, RegionRows& rows) {
  ObjectRow& planning = FdmOf(object).object;
  if (absl::Status ok = AddSupportRows(object, rows); !ok.ok()) return ok;
  const int32_t raft_layers = planning.raft.heights.layers;
  for (int32_t layer = 0; layer < raft_layers; ++layer) {
    absl::StatusOr<int32_t> row = rows.RowOf(RaftRow(object, layer));
    if (!row.ok()) return row.status();
    planning.raft_settings[static_cast<size_t>(layer)] = *row;
  }
  const BrimOptions& brim = planning.brim;
  const bool wide = brim.automatic.on || brim.width_nm > 0;
  if (brim.type == BrimType::kNone || !wide || raft_layers > 0) return absl::OkStatus();
  absl::StatusOr<int32_t> row = rows.RowOf(BrimRow(object));
  if (!row.ok()) return row.status();
  planning.brim_settings = *row;
  return absl::OkStatus();
}

absl::Status FinishPlate(const JobRows& job, RegionRows& rows, JobSettings& plate) {
  JobPlanOptions& plan = FdmOf(plate).machine.plan;
  if (plan.skirt.loops > 0) {
    const absl::StatusOr<int32_t> row = rows.RowOf(SkirtRow(job));
    if (!row.ok()) return row.status();
    plan.skirt_settings = *row;
  }
  rows.PutInto(plate);
  plan.find_air = std::ranges::any_of(
      FdmOf(plate).regions, [](const RegionRow& region) { return region.order.unsupported_last; });
  LeaveRoomForBrims(plate);
  return absl::OkStatus();
}

}  // namespace slicefarm::config::fdm
