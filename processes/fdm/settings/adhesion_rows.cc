#include "processes/fdm/settings/adhesion_rows.h"

#include <numbers>
#include <utility>

#include "common/model/options/adhesion_options.h"
#include "common/model/options/support_options.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/plain_row.h"

namespace slicefarm::config::fdm {
namespace {

/// More lines than fit into any brim.
constexpr int32_t kAllLines = 1'000;

/// Returns the density of a raft layer. The upper layers of a raft are the interface of supports
/// and have its spacing.
double DensityOf(const RaftOptions& raft, int32_t layer, const SupportOptions& support) {
  const RaftLayerKind kind = RaftLayerKindOf(layer, raft.heights.layers);
  if (kind == RaftLayerKind::kFirst) return raft.lines.first_layer_density;
  const Coord free_nm =
      kind == RaftLayerKind::kInterface ? support.interface_spacing_nm : raft.lines.spacing_nm;
  return LineDensity(raft.lines.width_nm, raft.heights.HeightOf(layer), free_nm);
}

}  // namespace

JobRows BrimRow(JobRows settings) {
  BeadingOptions& beading = FdmOf(settings).region.walls;
  SetWidths(beading.first_layer_width_nm, settings);
  beading.generator = WallGenerator::kArachne;
  beading.perimeters = kAllLines;
  MakePlain(beading);
  // A brim has no narrow places. A wider line there would overlap the object that the brim must not
  // touch.
  beading.min_feature_nm = beading.min_bead_width_nm = beading.first_layer_width_nm / 2;
  beading.gap_fill = true;
  FillAlike(1, 0, FdmOf(settings).region.infill);
  FdmOf(settings).region.order = {.towards_holes = true};
  FdmOf(settings).region.motion.flow[static_cast<size_t>(Feature::kSkirt)] =
      FdmOf(settings).object.brim.flow;
  return settings;
}

JobRows SkirtRow(JobRows settings) {
  const double speed_mm_s = FdmOf(settings).machine.plan.skirt.speed_mm_s;
  JobRows row = BrimRow(std::move(settings));
  FdmOf(row).region.motion.skirt_speed_mm_s = speed_mm_s;
  FdmOf(row).region.motion.flow[static_cast<size_t>(Feature::kSkirt)] = 1;
  return row;
}

JobRows RaftRow(JobRows settings, int32_t layer) {
  const RaftOptions& raft = FdmOf(settings).object.raft;
  const SupportOptions& support = FdmOf(settings).object.support;
  const int32_t layers = raft.heights.layers;
  const RaftLayerKind kind = RaftLayerKindOf(layer, layers);
  SetWidths(raft.lines.width_nm, settings);
  BeadingOptions& beading = FdmOf(settings).region.walls;
  MakePlain(beading);
  beading.generator = WallGenerator::kClassic;
  beading.perimeters = kind == RaftLayerKind::kInterface ? 0 : 1;
  beading.gap_fill = false;
  const bool two_bases = layers / 2 > 1;
  const bool across =
      kind == RaftLayerKind::kInterface || (kind == RaftLayerKind::kFirst && two_bases);
  FillAlike(DensityOf(raft, layer, support),
            raft.lines.angle_rad + (across ? std::numbers::pi / 2 : 0),
            FdmOf(settings).region.infill);
  InfillOptions& infill = FdmOf(settings).region.infill;
  if (beading.perimeters == 0) infill.overlap_nm = 0;
  FdmOf(settings).region.order = {};
  return settings;
}

}  // namespace slicefarm::config::fdm
