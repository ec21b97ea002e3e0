#include "processes/fdm/settings/support_rows.h"

#include <numbers>

#include "common/model/options/planning_options.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/plain_row.h"

namespace slicefarm::config::fdm {
namespace {

FillPattern PatternOf(SupportPattern pattern) {
  switch (pattern) {
    case SupportPattern::kRectilinear:
      return FillPattern::kAlignedRectilinear;
    case SupportPattern::kRectilinearGrid:
      return FillPattern::kRectilinear;
    case SupportPattern::kHoneycomb:
      return FillPattern::kHoneycomb;
  }
  return FillPattern::kAlignedRectilinear;
}

/// Returns the gap between lines of an interface.
Coord SpacingOf(const SupportOptions& support, SupportRow row) {
  const bool own = row == SupportRow::kBottomInterface && support.bottom_interface_spacing_nm >= 0;
  return own ? support.bottom_interface_spacing_nm : support.interface_spacing_nm;
}

/// Makes an interface solid, with a top surface that is ironed.
void Iron(const IroningOptions& ironing, InfillOptions& infill) {
  infill.density = 1;
  infill.top_solid_layers = 1;
  infill.top_flow = 1;
  infill.ironing = ironing;
}

/// Minimum length of tips at the ragged side of a support column. If a shorter tip is left out, the
/// object above it is within this distance of the column's other beads.
constexpr Coord kLeastTipNm = 1 * kNmPerMm;

void SetLines(const ObjectPlanOptions& object, SupportRow row, BeadingOptions& beading,
              InfillOptions& infill) {
  const SupportOptions& support = object.support;
  const double angle_rad = support.angle_rad;
  const auto density = [&](Coord free_nm) {
    return LineDensity(support.width_nm, support.layer_height_nm, free_nm);
  };
  switch (row) {
    case SupportRow::kFirstLayer:
      beading.perimeters = 1;
      FillAlike(object.raft.lines.first_layer_density, angle_rad, infill);
      return;
    case SupportRow::kBase:
      beading.perimeters = support.sheath ? 1 : 0;
      beading.least_tip_nm = kLeastTipNm;
      FillAlike(density(support.spacing_nm), angle_rad, infill);
      infill.pattern = PatternOf(support.pattern);
      return;
    case SupportRow::kBranch:
    case SupportRow::kThickBranch:
      beading.perimeters = row == SupportRow::kBranch ? 1 : 2;
      FillAlike(0, angle_rad, infill);
      return;
    case SupportRow::kInterface:
    case SupportRow::kBottomInterface:
      // A loop ends exactly at the region's edge, and fits into narrow strips without space for
      // crossing lines.
      beading.perimeters = support.contact_loops && row == SupportRow::kInterface ? 2 : 1;
      FillAlike(density(SpacingOf(support, row)), angle_rad + std::numbers::pi / 2, infill);
      if (support.interface_pattern == InterfacePattern::kConcentric)
        infill.pattern = infill.solid_pattern = infill.top_pattern = infill.bottom_pattern =
            FillPattern::kConcentric;
      if (row == SupportRow::kInterface && support.ironing.enabled) Iron(support.ironing, infill);
      return;
  }
}

}  // namespace

JobRows SupportRegionRow(JobRows settings, SupportRow row) {
  const ObjectPlanOptions object = FdmOf(settings).object;
  SetWidths(object.support.width_nm, settings);
  BeadingOptions& beading = FdmOf(settings).region.walls;
  MakePlain(beading);
  beading.generator = WallGenerator::kClassic;
  beading.thin_walls = true;
  beading.gap_fill = false;
  InfillOptions& infill = FdmOf(settings).region.infill;
  SetLines(object, row, beading, infill);
  if (beading.perimeters == 0) infill.overlap_nm = 0;
  FdmOf(settings).region.order = {};
  return settings;
}

}  // namespace slicefarm::config::fdm
