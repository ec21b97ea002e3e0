#include "processes/fdm/settings/derive_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/reported_settings.h"
#include "common/config/table/settings_table.h"
#include "common/config/table/value.h"
#include "common/geometry/boolean/boolean.h"
#include "common/macro/job_code.h"
#include "common/model/bead_section.h"
#include "common/model/fields/field_text.h"
#include "common/model/limits.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/support_options.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/joined_gcode.h"
#include "processes/fdm/settings/shells.h"
#include "processes/fdm/settings/template_faults.h"

namespace slicefarm::config::fdm {
namespace {

/// Maximum number of tools of a machine.
constexpr double kMostTools = 255;

/// Returns the number of extruders of the machine: the number of its nozzles, or num_extruders if
/// it is larger.
size_t ToolCount(std::span<const Setting> given) {
  size_t nozzles = 1, extruders = 0;
  for (const Setting& setting : given) {
    if (setting.key == "nozzle_diameter") nozzles = Split(setting.value, ",;").size();
    const auto number = ToNumber(Trim(setting.value));
    if (setting.key == "num_extruders" && number && *number >= 1 && *number <= kMostTools)
      extruders = static_cast<size_t>(*number);
  }
  return std::max(nozzles, extruders);
}

absl::Status DeriveLayerSettings(const std::string& text, MachineMotion& options) {
  std::string code = options.before_layer_gcode.str() + "\n" + options.layer_gcode.str() + "\n" +
                     options.role_gcode.str();
  const WritingOptions& writing = options.writing;
  if (!writing.height_code.empty())
    for (const SharedText& text_there :
         {writing.color_change_gcode, writing.pause_gcode, writing.template_gcode})
      code += "\n" + text_there.str();
  options.layer_settings = LinesNamedIn(code, text);
  const auto size = static_cast<int64_t>(options.layer_settings.size());
  if (size <= limits::kMaxSettingBytes) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "bytes of the settings that layer_gcode names",
                    limits::kMaxSettingBytes, size);
}

/// Sets the width of thin parts that elefant_foot_compensation must preserve: space for the outer
/// wall of the first layer and the adjacent wall, as in PrusaSlicer.
void DeriveFootWidth(JobRows& settings) {
  const Coord width_nm = FdmOf(settings).region.walls.first_layer_width_nm;
  const Coord spacing_nm = Spacing(width_nm, settings.slicing.first_layer_height_nm);
  settings.object.elephant_foot_min_width_nm = width_nm + std::max<Coord>(spacing_nm, 0);
}

/// Copies the number of layers in which elefant_foot_layers_density acts. Objects on a raft have no
/// such layers.
void DeriveFootDensity(JobRows& settings) {
  SolidOptions& solid = FdmOf(settings).region.infill.solid;
  if (!settings.object.on_bed) solid.foot_density = 1;
  solid.foot_layers = solid.foot_density < 1 ? settings.object.elephant_foot_layers : 1;
}

/// Copies the nozzle's diameter, which decides the number of edges of polyholes.
void DerivePolyholes(JobRows& settings) {
  settings.object.polyholes.nozzle_nm = FromMm(FdmOf(settings).tool.nozzle_diameter_mm);
}

/// Sets the waves of a stiff gyroid by the density and the height of its lines, as OrcaSlicer does:
/// the square root of the density of the waves, less for lines that are high beside their distance.
void DeriveGyroid(JobRows& settings) {
  constexpr double kWavesPerDensity = 2.44;
  InfillOptions& infill = FdmOf(settings).region.infill;
  PatternOptions& shape = infill.shape;
  shape.gyroid_waves = 1;
  if (!shape.stiff_gyroid || infill.pattern != FillPattern::kGyroid) return;
  const Coord height_nm = settings.object.layer_height_nm;
  const auto spacing = static_cast<double>(Spacing(infill.sparse_width_nm, height_nm));
  if (spacing <= 0) return;
  const double height_share = static_cast<double>(height_nm) / (spacing * shape.lines);
  const double waves =
      std::sqrt(infill.density * kWavesPerDensity / shape.lines / (1 + height_share));
  shape.gyroid_waves = std::clamp(waves, kLeastGyroidWaves, kMostGyroidWaves);
}

/// Sets the space for the head around arranged copies that are printed one after another.
void DeriveClearance(JobRows& settings) {
  const SequencePlanOptions& sequence = FdmOf(settings).machine.plan.sequence;
  settings.slicing.clearance_radius_nm =
      sequence.complete_objects ? sequence.clearance_radius_nm : 0;
}

/// Requests the pictures of a .gcode.3mf archive, in the sizes of Bambu Studio.
void DerivePictures(JobRows& settings) {
  if (!FdmOf(settings).machine.motion.writing.archive) return;
  constexpr int32_t kLargePx = 512, kSmallPx = 128;
  for (const auto& [role, px] :
       {std::pair(PictureRole::kPlate, kLargePx), std::pair(PictureRole::kPlate, kSmallPx),
        std::pair(PictureRole::kUnlit, kLargePx), std::pair(PictureRole::kTop, kLargePx),
        std::pair(PictureRole::kPick, kLargePx)})
    settings.slicing.thumbnails.push_back({px, px, PictureFormat::kPng, role});
}

/// Returns the material and speed data of auto_brim: the length at which a part warps, the
/// adhesion, and the highest print speed. The material values are OrcaSlicer's.
AutomaticBrim AutomaticBrimOf(const JobRows& settings) {
  struct Material {
    std::string_view type;
    double thermal_length_mm, adhesion;
  };
  constexpr Material kMaterials[] = {{"ABS", 100, 1}, {"PA-CF", 100, 1},  {"PET-CF", 100, 1},
                                     {"PC", 40, 1},   {"TPU", 1000, 0.5}, {"PETG", 200, 2},
                                     {"PCTG", 200, 2}};
  AutomaticBrim brim = FdmOf(settings).object.brim.automatic;
  const auto material =
      std::ranges::find(kMaterials, FdmOf(settings).tool.filament_type, &Material::type);
  if (material != std::end(kMaterials)) {
    brim.thermal_length_mm = material->thermal_length_mm;
    brim.adhesion = material->adhesion;
  }
  const auto& speeds = FdmOf(settings).region.motion.speed_mm_s;
  for (const Feature feature : {Feature::kExternalPerimeter, Feature::kPerimeter,
                                Feature::kInternalInfill, Feature::kSolidInfill})
    brim.max_speed_mm_s = std::max(brim.max_speed_mm_s, speeds[static_cast<size_t>(feature)]);
  return brim;
}

/// Copies values that skirt, brim and raft need from other settings.
void DeriveAdhesion(JobRows& settings) {
  const Coord first_height_nm = settings.slicing.first_layer_height_nm;
  const Coord line_width_nm = FdmOf(settings).region.walls.first_layer_width_nm;
  SkirtOptions& skirt = FdmOf(settings).machine.plan.skirt;
  skirt.width_nm = line_width_nm;
  skirt.height_nm = first_height_nm;
  const double radius_mm = FdmOf(settings).tool.filament_diameter_mm / 2;
  skirt.filament_area_mm2 = std::numbers::pi * radius_mm * radius_mm;
  ObjectPlanOptions& object = FdmOf(settings).object;
  object.brim.line_width_nm = line_width_nm;
  object.brim.foot_nm = settings.object.elephant_foot_nm;
  object.brim.automatic = AutomaticBrimOf(settings);
  RaftHeights& raft = object.raft.heights;
  raft.first_nm = first_height_nm;
  raft.others_nm = std::max(settings.object.layer_height_nm,
                            FromMm(0.75 * FdmOf(settings).tool.nozzle_diameter_mm));
  settings.object.on_bed = raft.layers == 0;
  settings.object.lift_nm = raft.LiftNm();
  object.raft_settings.assign(static_cast<size_t>(raft.layers), 0);
}

/// Returns the name of the setting that covers the whole bed. If each of the two settings covers
/// only a part of it, returns the name of bed_exclude_area.
std::string_view NameOfCover(const JobSlicingOptions& slicing) {
  const auto covers = [&](const std::vector<Polygon>& excluded) {
    return Difference({{slicing.bed, {}}}, Union(excluded, FillRule::kNonZero)).empty();
  };
  const bool alone = !covers(slicing.excluded) && covers(slicing.wrapping);
  return alone ? "wrapping_exclude_area" : "bed_exclude_area";
}

/// Sets the area for planning: the bed without its excluded areas. Sets the same area for travel if
/// there are excluded areas.
absl::Status DeriveTravelArea(JobRows& settings) {
  const JobSlicingOptions& slicing = settings.slicing;
  MachineRow& machine = FdmOf(settings).machine;
  if (slicing.bed.empty()) return absl::OkStatus();
  machine.plan.bed = {{slicing.bed, {}}};
  const std::vector<Polygon> excluded = AllExcluded(slicing);
  if (excluded.empty()) return absl::OkStatus();
  machine.plan.bed = Difference(machine.plan.bed, Union(excluded, FillRule::kNonZero));
  machine.order.travel.travel_area = machine.motion.travel_area = machine.plan.bed;
  if (!machine.plan.bed.empty()) return absl::OkStatus();
  const std::string name(NameOfCover(slicing));
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} leaves nothing of bed_shape", name), {{"setting", name}});
}

constexpr Coord kLowestLayerNm = 10'000;

/// Limits the range of adaptive layer heights.
void DeriveAdaptiveHeights(JobRows& settings) {
  AdaptiveHeights& adaptive = settings.object.adaptive;
  const Coord nozzle_nm = FromMm(FdmOf(settings).tool.nozzle_diameter_mm);
  if (adaptive.max_nm == 0) adaptive.max_nm = nozzle_nm * 3 / 4;
  adaptive.max_nm = std::max(adaptive.max_nm, kLowestLayerNm);
  adaptive.min_nm = std::clamp<Coord>(adaptive.min_nm, kLowestLayerNm, adaptive.max_nm);
}

/// Copies values that supports need from other settings.
void DeriveSupports(JobRows& settings) {
  SupportOptions& support = FdmOf(settings).object.support;
  support.wall_width_nm = FdmOf(settings).region.walls.external_width_nm;
  support.walls_nm = FdmOf(settings).region.infill.walls_nm;
  support.layer_height_nm = settings.object.layer_height_nm;
  support.first_layer_height_nm =
      settings.object.on_bed ? settings.slicing.first_layer_height_nm : support.layer_height_nm;
  support.min_layer_height_nm = std::min(support.min_layer_height_nm, support.layer_height_nm);
}

/// Sets the total width of the walls of an island that has space for all of them.
void DeriveWalls(JobRows& settings) {
  const BeadingOptions& walls = FdmOf(settings).region.walls;
  FdmOf(settings).region.infill.walls_nm =
      walls.perimeters == 0
          ? 0
          : walls.external_width_nm + (walls.perimeters - 1) * walls.inner_width_nm;
}

/// Sets the first hollow layer of a vase. Its bottom has the requested number of layers, and at
/// least one.
void DeriveVaseOptions(const SettingValues& draft, JobRows& settings) {
  int32_t& hollow_from = settings.object.hollow_from;
  if (hollow_from == 0) return;
  const BeadingOptions& walls = FdmOf(settings).region.walls;
  hollow_from = std::max(1, BottomLayers(settings));
  FdmOf(settings).object.spiral = {
      .width_nm = walls.external_width_nm,
      .blends = walls.fuzzy == FuzzySkin::kNone && draft.Number("spiral_vase_smooth") != 0};
}

/// Sets the halo of a density field: the number of layers above and below that a density depends on
/// through the distance to the surface.
absl::Status DeriveDensityField(JobRows& settings) {
  InfillOptions& infill = FdmOf(settings).region.infill;
  if (infill.density_field.empty()) return absl::OkStatus();
  const auto& field = DensityFieldOf(infill.density_field);
  if (!field.ok()) return field.status();
  if (field->dither != Dither::kNone && !infill.stress_field.empty()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     "density_field: dither has no effect on the lines of stress_field: omit "
                     "dither or stress_field",
                     {{"setting", "density_field"}});
  }
  const double height_mm = ToMm(settings.object.layer_height_nm);
  const double layers = std::ceil(field->ReachMm() / height_mm);
  if (layers > static_cast<double>(limits::kMaxFieldHaloLayers)) {
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
        fmt::format("density_field: length = {} mm is out of range: it must be at most "
                    "{} layers of layer_height = {} mm",
                    PrintNumber(field->ReachMm()), limits::kMaxFieldHaloLayers,
                    PrintNumber(height_mm)),
        {{"setting", "density_field"}});
  }
  infill.field_halo_layers = static_cast<int32_t>(layers);
  return absl::OkStatus();
}

/// Refuses density fields for patterns that planning lays out, because these patterns cannot follow
/// a field.
absl::Status CheckPlannedPattern(const InfillOptions& infill) {
  const bool planned = infill.choose_pattern || InfoOf(infill.pattern).planned;
  if (!planned || infill.density_field.empty()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("density_field: fill_pattern = {} cannot follow a density field, "
                               "because it is planned over the whole part: choose another pattern",
                               infill.choose_pattern ? "auto" : InfoOf(infill.pattern).name),
                   {{"setting", "density_field"}});
}

ShrinkageCompensation ShrinkageCompensationOf(const SettingValues& draft) {
  const auto factor = [&](std::string_view key) { return 100 / (100 - draft.Number(key)); };
  return {factor("filament_shrinkage_compensation_xy"),
          factor("filament_shrinkage_compensation_z")};
}

/// Limits the number of combined infill layers so that beads are not higher than the nozzle
/// diameter. Returns a note if the number changed.
std::optional<std::string> DeriveEveryLayers(JobRows& settings) {
  int32_t& every = FdmOf(settings).region.infill.every_layers;
  const Coord height_nm = settings.object.layer_height_nm;
  const Coord nozzle_nm = FromMm(FdmOf(settings).tool.nozzle_diameter_mm);
  const auto most = static_cast<int32_t>(std::max<Coord>(1, nozzle_nm / height_nm));
  if (every <= most) return std::nullopt;
  const int32_t asked = std::exchange(every, most);
  return fmt::format("infill_every_layers = {}: layer_height and nozzle_diameter allow only {}",
                     asked, most);
}

/// Lays inner walls against outer walls as usual if they are printed after them: then nothing
/// presses the outer walls outwards.
void DerivePreciseWalls(JobRows& settings) {
  const WallOrder& order = FdmOf(settings).region.order;
  if (order.external_perimeters_first || order.inner_outer_inner)
    FdmOf(settings).region.walls.precise_outer = false;
}

/// Copies the settings of Z contouring to the stages that use them. Walls are printed from the
/// outside, where the surface is lowest, so that the nozzle never dips beside higher walls.
void DeriveContour(JobRows& settings) {
  const SurfaceContour& contour = settings.object.contour;
  RegionRow& region = FdmOf(settings).region;
  region.motion.contour_least_nm = contour.on ? contour.least_nm : 0;
  region.infill.same_direction = region.infill.same_direction && contour.on;
  if (!contour.on) return;
  region.order.external_perimeters_first = true;
  region.order.inner_outer_inner = false;
}

/// Makes inner walls with a scarf separate loops. A wall that is printed in one path with the next
/// wall has no seam for a scarf.
void DeriveInnerScarfs(JobRows& settings) {
  const ScarfOptions& scarf = FdmOf(settings).region.motion.scarf;
  FdmOf(settings).region.order.whole_loops =
      scarf.placement != ScarfPlacement::kNowhere && scarf.on_inner;
}

/// Sets the limits of the machine's silent mode: the second value of each list, or the first value
/// of a list with only one. Only Marlin firmware has a silent mode.
absl::Status DeriveSilentMode(const SettingValues& draft, JobRows& settings) {
  MachineMotion& motion = FdmOf(settings).machine.motion;
  const bool marlin =
      motion.flavor == GcodeFlavor::kMarlin2 || motion.flavor == GcodeFlavor::kMarlinLegacy;
  if (!marlin || draft.Number("silent_mode") == 0) return absl::OkStatus();
  JobRows silent{.slicing = {}, .object = {}, .own = FdmRows()};
  FdmOf(silent).machine.motion.limits = motion.limits;
  const auto table = SettingsTable(draft.process());
  for (size_t i = 0; i < table.size(); ++i) {
    if (table[i].list != List::kPerMode || draft.Number("machine_limits_usage") == kIgnoreLimits)
      continue;
    const std::vector<std::string_view> values = Split(draft.entries()[i].all, ",");
    if (values.size() < 2) continue;
    const auto value = ParseValue(table[i], Trim(values[1]));
    if (!value.ok()) return value.status();
    table[i].field.set(silent, *value);
  }
  motion.silent_limits = FdmOf(silent).machine.motion.limits;
  return absl::OkStatus();
}

/// Sets the number of the tool that prints, if the machine has several tools.
void DeriveTool(const OptionSources& sources) {
  const size_t tools = ToolCount(sources.given);
  if (tools <= 1) return;
  FdmOf(sources.result.settings).tool.number = static_cast<int32_t>(ToolOf(sources.given));
  sources.reported["num_extruders"] = fmt::format("{}", tools);
}

}  // namespace

size_t ToolOf(std::span<const Setting> given) {
  size_t tool = 0;
  for (const Setting& setting : given) {
    if (setting.key != "extruder") continue;
    const auto number = ToNumber(Trim(setting.value));
    const bool valid = number && *number >= 1 && *number <= kMostTools;
    tool = valid ? static_cast<size_t>(*number) - 1 : 0;
  }
  return tool;
}

absl::Status DeriveOptions(const OptionSources& sources) {
  JobRows& settings = sources.result.settings;
  sources.result.shrinkage = ShrinkageCompensationOf(sources.draft);
  DerivePolyholes(settings);
  DeriveFootWidth(settings);
  DeriveTool(sources);
  if (absl::Status ok = DeriveSilentMode(sources.draft, settings); !ok.ok()) return ok;
  auto code = macro::ParseJobCode(MotionOf(FdmOf(settings)));
  while (!code.ok() && LeaveOutTemplate(code.status(), sources.draft, sources.result))
    code = macro::ParseJobCode(MotionOf(FdmOf(settings)));
  if (!code.ok()) return NamingOwnGcode(code.status(), sources.draft);
  if (!macro::NamesClock(*code)) sources.reported.erase("creation_time");
  DeriveClearance(settings);
  DerivePictures(settings);
  DeriveAdhesion(settings);
  DeriveFootDensity(settings);
  DeriveGyroid(settings);
  if (absl::Status ok = DeriveTravelArea(settings); !ok.ok()) return ok;
  DeriveAdaptiveHeights(settings);
  DeriveWalls(settings);
  DeriveSupports(settings);
  DeriveShells(sources.draft, settings);
  DeriveVaseOptions(sources.draft, settings);
  DeriveContour(settings);
  DeriveInnerScarfs(settings);
  DerivePreciseWalls(settings);
  if (absl::Status ok = DeriveDensityField(settings); !ok.ok()) return ok;
  if (absl::Status ok = CheckPlannedPattern(FdmOf(settings).region.infill); !ok.ok()) return ok;
  if (auto note = DeriveEveryLayers(settings))
    sources.result.no_effect.push_back({*std::move(note)});
  return absl::OkStatus();
}

absl::Status DeriveGcode(const SettingValues& draft, ResolvedSettings& result) {
  const FdmRows& rows = FdmOf(result.settings);
  absl::Status ok = macro::CheckJobCode(MotionOf(rows), result.effective_text);
  while (!ok.ok() && LeaveOutTemplate(ok, draft, result))
    ok = macro::CheckJobCode(MotionOf(rows), result.effective_text);
  if (!ok.ok()) return NamingOwnGcode(ok, draft);
  return DeriveLayerSettings(result.effective_text, FdmOf(result.settings).machine.motion);
}

}  // namespace slicefarm::config::fdm
