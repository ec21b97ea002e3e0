#include "processes/laser/job/laser_report.h"

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator {
namespace {

using OrderedJson = nlohmann::ordered_json;

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

}  // namespace

void LaserReport::AddTo(nlohmann::ordered_json& json) const {
  json["exposure"] = Exposure(exposure);
  json["exposure"]["recoating_s"] = recoating_s;
  json["exposure"]["layers_s"] = layer_s;
}

}  // namespace slicefarm::coordinator
