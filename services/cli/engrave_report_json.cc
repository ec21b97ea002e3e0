#include "services/cli/engrave_report_json.h"

#include <nlohmann/json.hpp>

namespace slicefarm::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson JsonOf(const texture::Spread& spread) {
  return {{"p1", spread.p1}, {"p50", spread.p50}, {"p99", spread.p99}};
}

OrderedJson JsonOf(const texture::LayerNumbers& layer) {
  OrderedJson json = {{"layer", layer.layer},
                      {"height_mm", layer.height_mm},
                      {"offset_mm", layer.offset_mm},
                      {"spacing_mm", layer.spacing_mm},
                      {"lines", layer.runs},
                      {"points", layer.points},
                      {"on_mm", layer.on_mm},
                      {"off_mm", layer.off_mm},
                      {"tile_section_mm2", layer.section_mm2}};
  if (layer.folds > 0) {
    const Eigen::Vector3d& p = layer.first_fold_mm;
    json["folds"] = {{"places", layer.folds},
                     {"length_mm", layer.folds_mm},
                     {"first_mm", {p.x(), p.y(), p.z()}}};
  }
  return json;
}

}  // namespace

std::string EngraveReportJson(const EngraveJobReport& report) {
  double on = 0, off = 0;
  OrderedJson layers = OrderedJson::array();
  for (const texture::LayerNumbers& layer : report.layers) {
    on += layer.on_mm;
    off += layer.off_mm;
    layers.push_back(JsonOf(layer));
  }
  OrderedJson json = {{"layer_count", report.layers.size()},
                      {"map",
                       {{"faces", report.map.faces},
                        {"area_mm2", report.map.area_mm2},
                        {"energy_mean_over_4", report.map.energy_mean},
                        {"energy_max_over_4", report.map.energy_max},
                        {"stretch", JsonOf(report.map.stretch)}}},
                      {"line_distance_mm", JsonOf(report.map.line_distance_mm)},
                      {"line_length_within_10_percent", report.map.line_even},
                      {"on_mm", on},
                      {"off_mm", off},
                      {"layers", layers},
                      {"map_seconds", report.map_seconds},
                      {"path_seconds", report.path_seconds},
                      {"warnings", report.warnings}};
  if (report.program.moves > 0) {
    const texture::ProgramFacts& program = report.program;
    json["program"] = {{"moves", program.moves},
                       {"time_s", program.seconds},
                       {"filament_mm", program.filament_mm},
                       {"least_angles_deg", {program.least_deg.x(), program.least_deg.y()}},
                       {"most_angles_deg", {program.most_deg.x(), program.most_deg.y()}}};
  }
  return json.dump(2) + "\n";
}

}  // namespace slicefarm::cli
