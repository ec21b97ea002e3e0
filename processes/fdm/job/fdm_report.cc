#include "processes/fdm/job/fdm_report.h"

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator {
namespace {

using OrderedJson = nlohmann::ordered_json;

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

/// Returns the infill section of the report. Sparse infill is reported with its density. Other
/// infill is reported with its coverage, because it should cover the filled area completely.
OrderedJson Infill(const std::vector<FillStats>& fills) {
  OrderedJson list = OrderedJson::array();
  for (const FillStats& use : fills) {
    const bool sparse = use.feature == Feature::kInternalInfill;
    OrderedJson json = {
        {"settings", use.settings},
        {"feature", FeatureName(use.feature)},
        {"pattern", use.pattern ? OrderedJson(InfoOf(*use.pattern).name) : OrderedJson()},
        {sparse ? "density_asked" : "coverage_asked", use.asked_mm3 / use.volume_mm3},
        {sparse ? "density" : "coverage", use.plastic_mm3 / use.volume_mm3},
        {"area_mm2", use.area_mm2},
        {"volume_mm3", use.plastic_mm3},
        {"paths", use.paths},
        {"length_mm", use.length_mm},
        {"longest_path_mm", use.longest_mm}};
    list.push_back(std::move(json));
  }
  return list;
}

OrderedJson Travel(const FdmReport& report) {
  return {{"length_mm", report.travel_mm},
          {"time_s", report.stats.travel_time_s},
          {"retract_time_s", report.stats.retract_time_s},
          {"count", report.stats.travels},
          {"retractions", report.stats.retractions}};
}

/// Returns the parts of print_time_s that `features` and `travel` do not contain, and the total
/// time by layer.
OrderedJson Times(const PrintTimes& times) {
  return {{"custom_gcode_s", times.custom_s},  {"dwell_s", times.dwell_s},
          {"heating_s", times.heating_s},      {"homings", times.homings},
          {"heat_waits", times.heat_waits},    {"tool_changes", times.tool_changes},
          {"before_layers_s", times.before_s}, {"layers_s", times.layer_s},
          {"after_layers_s", times.after_s}};
}

/// Returns the seam section of the report. Each share is a fraction of the loops to which it can
/// apply, or null if there are none.
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

}  // namespace

void FdmReport::AddTo(nlohmann::ordered_json& json) const {
  json["file_name"] = file_name;
  json["filament"] = {{"mm", filament.length_mm},
                      {"mm3", filament.volume_mm3},
                      {"g", filament.mass_g},
                      {"cost", filament.cost}};
  json["features"] = Features(stats);
  json["infill"] = Infill(fills);
  json["travel"] = Travel(*this);
  json["times"] = Times(times);
  json["seams"] = Seams(seams);
}

}  // namespace slicefarm::coordinator
