#include "processes/fdm/settings/adhesion_rows.h"

#include <numbers>
#include <utility>

namespace slicefarm::config::fdm {
namespace {

/// More than fit into any brim.
constexpr int32_t kAllLines = 1'000;

/// Beads of one width in place of what the part's walls and infill have.
void SetWidths(Coord width_nm, JobSettings& settings) {
  BeadingOptions& beading = FdmOf(settings).beading.front();
  beading.external_width_nm = beading.inner_width_nm = width_nm;
  InfillOptions& infill = FdmOf(settings).infill.front();
  infill.sparse_width_nm = infill.solid_width_nm = infill.top_width_nm = width_nm;
}

/// Nothing but the number of walls that is asked for.
void MakePlain(BeadingOptions& beading) {
  beading.one_on_bed = false;
  beading.one_on_top = OneWallOnTop::kNowhere;
  beading.extra_perimeters = false;
  beading.fuzzy = FuzzySkin::kNone;
}

/// No skins: all of a region is filled alike.
void FillAlike(double density, double angle_rad, InfillOptions& infill) {
  infill.top_solid_layers = infill.bottom_solid_layers = 0;
  infill.density = density;
  infill.pattern = FillPattern::kAlignedRectilinear;
  infill.choose_pattern = false;
  infill.solid_pattern = infill.top_pattern = infill.bottom_pattern = FillPattern::kRectilinear;
  infill.angle_rad = angle_rad;
  infill.angle_template.clear();
  infill.solid_angle_template.clear();
  infill.solid_below_area_mm2 = 0;
  infill.solid_every_layers = 0;
  infill.bridge_angle_rad = 0;
  infill.every_layers = 1;
  infill.only_where_needed = false;
  infill.over_bridges = false;
  infill.interface_shells = false;
  infill.ironing = {};
  infill.small_area_flow = false;
  infill.density_field.clear();
  infill.stress_field.clear();
  infill.field_halo_layers = 0;
}

double DensityOf(RaftLayerKind kind, const RaftLines& lines) {
  if (kind == RaftLayerKind::kInterface) return 1;
  if (kind == RaftLayerKind::kFirst) return lines.first_layer_density;
  const auto width = static_cast<double>(lines.width_nm);
  return width / (width + static_cast<double>(lines.spacing_nm));
}

}  // namespace

JobSettings BrimRow(JobSettings settings) {
  BeadingOptions& beading = FdmOf(settings).beading.front();
  SetWidths(beading.first_layer_width_nm, settings);
  beading.generator = WallGenerator::kArachne;
  beading.perimeters = kAllLines;
  MakePlain(beading);
  // A brim has no narrower places: a wider line there would lie on what it keeps away from.
  beading.min_feature_nm = beading.min_bead_width_nm = beading.first_layer_width_nm / 2;
  beading.gap_fill = true;
  FillAlike(1, 0, FdmOf(settings).infill.front());
  FdmOf(settings).ordering.walls.front() = {.towards_holes = true};
  return settings;
}

JobSettings RaftRow(JobSettings settings, int32_t layer) {
  const RaftOptions& raft = FdmOf(settings).planning.objects.front().raft;
  const int32_t layers = raft.heights.layers;
  const RaftLayerKind kind = RaftLayerKindOf(layer, layers);
  SetWidths(raft.lines.width_nm, settings);
  BeadingOptions& beading = FdmOf(settings).beading.front();
  MakePlain(beading);
  beading.generator = WallGenerator::kClassic;
  beading.perimeters = kind == RaftLayerKind::kInterface ? 0 : 1;
  beading.gap_fill = false;
  const bool two_bases = layers / 2 > 1;
  const bool across =
      kind == RaftLayerKind::kInterface || (kind == RaftLayerKind::kFirst && two_bases);
  FillAlike(DensityOf(kind, raft.lines), raft.lines.angle_rad + (across ? std::numbers::pi / 2 : 0),
            FdmOf(settings).infill.front());
  InfillOptions& infill = FdmOf(settings).infill.front();
  if (beading.perimeters == 0) infill.overlap_nm = 0;
  // The layers' own directions are planned: none turns by itself.
  infill.solid_pattern = infill.top_pattern = infill.bottom_pattern =
      FillPattern::kAlignedRectilinear;
  FdmOf(settings).ordering.walls.front() = {};
  return settings;
}

}  // namespace slicefarm::config::fdm
