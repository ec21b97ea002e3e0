#include "processes/fdm/settings/plain_row.h"

#include <algorithm>

#include "common/model/bead_section.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm {

void SetWidths(Coord width_nm, JobRows& settings) {
  BeadingOptions& beading = FdmOf(settings).region.walls;
  beading.external_width_nm = beading.inner_width_nm = width_nm;
  InfillOptions& infill = FdmOf(settings).region.infill;
  infill.sparse_width_nm = infill.solid_width_nm = infill.top_width_nm = width_nm;
}

void MakePlain(BeadingOptions& beading) {
  beading.one_on_bed = false;
  beading.one_on_top = OneWallOnTop::kNowhere;
  beading.alternate_extra = false;
  beading.min_length_factor = 0;
  beading.extra_perimeters = false;
  beading.fuzzy = FuzzySkin::kNone;
  beading.texture = {};
  beading.precise_outer = false;
  beading.gap_target = GapFillTarget::kEverywhere;
  beading.min_gap_length_nm = 0;
  beading.min_top_width_nm = 0;
  beading.first_layer_min_bead_nm = 0;
}

void FillAlike(double density, double angle_rad, InfillOptions& infill) {
  infill.top_solid_layers = infill.bottom_solid_layers = 0;
  infill.top_spare = infill.bottom_spare = {};
  infill.density = density;
  infill.pattern = FillPattern::kAlignedRectilinear;
  infill.choose_pattern = false;
  infill.shape = {};
  infill.zones = {};
  infill.solid = {};
  infill.surfaces = {};
  infill.bridges.extra = ExtraBridges::kNone;
  infill.bridges.internal_angle_rad = 0;
  infill.follows_model = false;
  infill.solid_pattern = infill.top_pattern = infill.bottom_pattern =
      FillPattern::kAlignedRectilinear;
  infill.angle_rad = angle_rad;
  infill.same_direction = false;
  infill.angle_template.clear();
  infill.solid_angle_template.clear();
  infill.solid_below_area_mm2 = 0;
  infill.solid_every_layers = 0;
  infill.bridge_angle_rad = 0;
  infill.every_layers = 1;
  infill.only_where_needed = false;
  infill.over_bridges = infill.internal_bridges = false;
  infill.internal_bridge_flow = 0;
  infill.bottom_flow = 1;
  infill.bridge_density = infill.internal_bridge_density = 1;
  infill.surface_overlap_nm = -1;
  infill.solid_angle_rad = -1;
  infill.interface_shells = false;
  infill.ironing = {};
  infill.small_area_flow = false;
  infill.density_field.clear();
  infill.stress_field.clear();
  infill.field_halo_layers = 0;
}

double LineDensity(Coord width_nm, Coord height_nm, Coord free_nm) {
  // Invalid widths are refused where lines are laid.
  const auto spacing = static_cast<double>(std::max<Coord>(Spacing(width_nm, height_nm), 1));
  return spacing / (spacing + static_cast<double>(free_nm));
}

}  // namespace slicefarm::config::fdm
