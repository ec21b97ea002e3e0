#include "services/coordinator/algo/pipeline/report_json.h"

#include <nlohmann/json.hpp>

#include "common/base/duration_text.h"

namespace slicefarm::coordinator {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson ToJson(const MeshReport& mesh) {
  return {{"name", mesh.name},
          {"closed", mesh.Closed()},
          {"triangles", mesh.triangles},
          {"vertices", mesh.vertices},
          {"bodies", mesh.bodies},
          {"open_edges", mesh.open_edges},
          {"non_manifold_edges", mesh.non_manifold_edges},
          {"flipped_faces", mesh.flipped_faces},
          {"degenerate_faces", mesh.degenerate_faces},
          {"repeated_faces", mesh.repeated_faces},
          {"volume_mm3", mesh.volume_mm3},
          {"min_mm", mesh.min_mm},
          {"max_mm", mesh.max_mm},
          {"open_loops_closed", mesh.open_loops_closed},
          {"open_loops_dropped", mesh.open_loops_dropped},
          {"largest_gap_closed_mm", mesh.largest_gap_closed_mm},
          {"dropped_length_mm", mesh.dropped_length_mm},
          {"cracks_closed_mm", mesh.cracks_closed_mm},
          {"copies_off_bed", mesh.copies_off_bed},
          {"overlapping_copies", mesh.overlapping_copies}};
}

OrderedJson Features(const ProgramStats& stats) {
  OrderedJson features = OrderedJson::object();
  for (int i = 0; i < kFeatureCount; ++i) {
    const FeatureUse& use = stats.features[i];
    if (use.length_mm == 0) continue;
    features[std::string(FeatureName(static_cast<Feature>(i)))] = {{"time_s", use.time_s},
                                                                   {"length_mm", use.length_mm},
                                                                   {"filament_mm", use.filament_mm},
                                                                   {"volume_mm3", use.volume_mm3}};
  }
  return features;
}

OrderedJson ToJson(const StageTimes& times) {
  return {{"slicing", times.slicing_s},   {"planning", times.planning_s},
          {"beading", times.beading_s},   {"infill", times.infill_s},
          {"ordering", times.ordering_s}, {"motion", times.motion_s},
          {"exposure", times.exposure_s}};
}

OrderedJson Exposure(const ExposureReport& report) {
  OrderedJson kinds = OrderedJson::object();
  for (int i = 0; i < kExposureKindCount; ++i) {
    const KindExposure& kind = report.kinds[static_cast<size_t>(i)];
    if (kind.lines == 0) continue;
    kinds[std::string(ExposureKindName(static_cast<ExposureKind>(i)))] = {
        {"vectors", kind.vectors},
        {"lines", kind.lines},
        {"length_mm", kind.length_mm},
        {"time_s", kind.time_s},
        {"energy_j", kind.energy_j}};
  }
  const KindExposure total = report.Total();
  return {{"time_s", report.TimeS()},
          {"exposed_mm", total.length_mm},
          {"vectors", total.vectors},
          {"laser_on", total.lines},
          {"laser_off", total.lines},
          {"jumps", report.jumps},
          {"jump_mm", report.jump_mm},
          {"jump_time_s", report.jump_time_s},
          {"energy_j", total.energy_j},
          {"energy_density_j_mm3", report.EnergyDensityJmm3()},
          {"area_mm2", report.area_mm2},
          {"volume_mm3", report.volume_mm3},
          {"melted", report.melted.Melted()},
          {"energy_j_mm2",
           {{"least", report.melted.least_j_mm2},
            {"mean", report.melted.MeanJmm2()},
            {"most", report.melted.most_j_mm2}}},
          {"kinds", kinds},
          {"pieces", report.cuts.pieces},
          {"reflex_corners", report.cuts.reflex},
          {"extra_points", report.cuts.extra_points},
          {"sharp_cuts", report.cuts.sharp_cuts},
          {"replaced_outlines", report.cuts.replaced}};
}

/// Sparse infill has a density, all else of it is to cover what it fills.
OrderedJson Infill(const std::vector<FillUse>& fills) {
  OrderedJson list = OrderedJson::array();
  for (const FillUse& use : fills) {
    const bool sparse = use.feature == Feature::kInternalInfill;
    OrderedJson json = {
        {"settings", use.settings},
        {"feature", FeatureName(use.feature)},
        {"pattern", use.pattern ? OrderedJson(InfoOf(*use.pattern).name) : OrderedJson()},
        {sparse ? "density_asked" : "coverage_asked", use.asked_mm3 / use.room_mm3},
        {sparse ? "density" : "coverage", use.plastic_mm3 / use.room_mm3},
        {"area_mm2", use.area_mm2},
        {"volume_mm3", use.plastic_mm3},
        {"paths", use.paths},
        {"length_mm", use.length_mm},
        {"longest_path_mm", use.longest_mm}};
    list.push_back(std::move(json));
  }
  return list;
}

OrderedJson Travel(const JobReport& report) {
  return {{"length_mm", report.travel_mm},
          {"time_s", report.stats.travel_time_s},
          {"retract_time_s", report.stats.retract_time_s},
          {"count", report.stats.travels},
          {"retractions", report.stats.retractions}};
}

/// Parts of print_time_s, beside those that `features` and `travel` tell, and all of it by layer.
OrderedJson Times(const PrintTimes& times) {
  return {{"custom_gcode_s", times.custom_s},  {"dwell_s", times.dwell_s},
          {"heating_s", times.heating_s},      {"homings", times.homings},
          {"heat_waits", times.heat_waits},    {"tool_changes", times.tool_changes},
          {"before_layers_s", times.before_s}, {"layers_s", times.layer_s},
          {"after_layers_s", times.after_s}};
}

/// Shares are of the loops that they can be of; none if there are no such loops.
OrderedJson Seams(const SeamQuality& seams) {
  const auto share = [](int64_t part, int64_t whole) {
    return whole == 0 ? OrderedJson()
                      : OrderedJson(static_cast<double>(part) / static_cast<double>(whole));
  };
  const int64_t steps = seams.followers - seams.jumps;
  OrderedJson json = {{"loops", seams.loops},
                      {"jumps", seams.jumps},
                      {"jumps_share", share(seams.jumps, seams.followers)},
                      {"mean_step_mm", OrderedJson()},
                      {"on_corner_share", share(seams.on_corner, seams.with_corner)},
                      {"overhanging_share", share(seams.overhanging, seams.loops)}};
  if (steps > 0) json["mean_step_mm"] = seams.steps_mm / static_cast<double>(steps);
  return json;
}

void AddFdm(const JobReport& report, OrderedJson& json) {
  json["file_name"] = report.file_name;
  json["filament"] = {{"mm", report.filament.length_mm},
                      {"mm3", report.filament.volume_mm3},
                      {"g", report.filament.mass_g},
                      {"cost", report.filament.cost}};
  json["features"] = Features(report.stats);
  json["infill"] = Infill(report.fills);
  json["travel"] = Travel(report);
  json["times"] = Times(report.times);
  json["seams"] = Seams(report.seams);
}

}  // namespace

std::string ReportJson(const JobReport& report, const ReportContext& context) {
  OrderedJson json;
  json["meshes"] = OrderedJson::array();
  for (const MeshReport& mesh : report.meshes) json["meshes"].push_back(ToJson(mesh));
  json["layers"] = report.layer_count;
  json["object_height_mm"] = report.object_height_mm;
  json["print_time_s"] = report.print_time_s;
  json["print_time"] = DurationText(report.print_time_s);
  if (report.exposure) {
    json["exposure"] = Exposure(*report.exposure);
    json["exposure"]["recoating_s"] = report.recoating_s;
    json["exposure"]["layers_s"] = report.times.layer_s;
  } else {
    AddFdm(report, json);
  }
  json["stage_times_s"] = ToJson(report.stage_times);
  json["warnings"] = report.warnings;
  json["notes"] = report.notes;
  json["settings_without_effect"] = context.settings_without_effect;
  json["settings_digest"] = context.settings_digest;
  json["build_id"] = context.build_id;
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace slicefarm::coordinator
