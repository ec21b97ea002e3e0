#include "processes/engrave/model/engrave_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace slicefarm {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr double kUneven = 1.5;  // of p99 to p1: a warning

OrderedJson JsonOf(const Spread& spread) {
  return {{"p1", spread.p1}, {"p50", spread.p50}, {"p99", spread.p99}};
}

OrderedJson JsonOf(const LayerNumbers& layer) {
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

void ProgramFacts::Add(const ProgramFacts& other) {
  seconds += other.seconds;
  filament_mm += other.filament_mm;
  moves += other.moves;
  least_deg = least_deg.cwiseMin(other.least_deg);
  most_deg = most_deg.cwiseMax(other.most_deg);
}

std::vector<std::string> WarningsOf(const MapReport& map, const std::vector<LayerNumbers>& layers) {
  std::vector<std::string> warnings;
  const Spread& distance = map.line_distance_mm;
  if (distance.p99 > kUneven * distance.p1)
    warnings.push_back(
        fmt::format("lines on the surface are {:.3g} to {:.3g} mm apart (1st to 99th percentile), "
                    "because the surface was stretched when it was laid flat; set equidistant = 1, "
                    "or cut the surface elsewhere",
                    distance.p1, distance.p99));
  int64_t folds = 0;
  double folds_mm = 0;
  const LayerNumbers* first = nullptr;
  for (const LayerNumbers& layer : layers) {
    folds += layer.folds;
    folds_mm += layer.folds_mm;
    if (layer.folds > 0 && first == nullptr) first = &layer;
  }
  if (first != nullptr) {
    const Eigen::Vector3d& p = first->first_fold_mm;
    warnings.push_back(
        fmt::format("in {} places the texture is higher than the radius of the surface, so that "
                    "the tool moves backwards along {:.2f} mm of lines; first place: layer {}, at "
                    "({:.3f}, {:.3f}, {:.3f}) mm. Use a lower texture",
                    folds, folds_mm, first->layer, p.x(), p.y(), p.z()));
  }
  const auto is_empty = [](const LayerNumbers& layer) { return layer.runs == 0; };
  if (!layers.empty() && std::all_of(layers.begin(), layers.end(), is_empty))
    warnings.push_back(
        "no line of the texture is on the surface: check `anchor`, texture_scale and `margin`");
  return warnings;
}

OrderedJson JsonOf(const EngraveReport& report) {
  double on = 0, off = 0;
  OrderedJson layers = OrderedJson::array();
  for (const LayerNumbers& layer : report.layers) {
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
                      {"layers", layers}};
  if (report.program.moves > 0) {
    const ProgramFacts& program = report.program;
    json["program"] = {{"moves", program.moves},
                       {"time_s", program.seconds},
                       {"filament_mm", program.filament_mm},
                       {"least_angles_deg", {program.least_deg.x(), program.least_deg.y()}},
                       {"most_angles_deg", {program.most_deg.x(), program.most_deg.y()}}};
  }
  return json;
}

}  // namespace slicefarm
