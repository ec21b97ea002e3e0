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

OrderedJson ToJson(const StageTimes& times) {
  OrderedJson json = OrderedJson::object();
  for (const StageInfo& info : kStages) json[std::string(info.name)] = times[info.stage];
  return json;
}

OrderedJson ToJson(const PrintShare& share) {
  return {{"time_s", share.time_s},
          {"filament",
           {{"mm", share.filament.length_mm},
            {"mm3", share.filament.volume_mm3},
            {"g", share.filament.mass_g},
            {"cost", share.filament.cost}}}};
}

OrderedJson ToJson(const ObjectShares& object) {
  OrderedJson json = {{"name", object.name}};
  json.update(ToJson(object.Total()));
  json["copies"] = OrderedJson::array();
  for (const PrintShare& copy : object.copies) json["copies"].push_back(ToJson(copy));
  return json;
}

void AddShares(const PrintShares& shares, OrderedJson& json) {
  if (shares.objects.empty()) return;
  json["objects"] = OrderedJson::array();
  for (const ObjectShares& object : shares.objects) json["objects"].push_back(ToJson(object));
  json["shared"] = ToJson(shares.shared);
}

OrderedJson ToJson(const CalibrationTable& table) {
  OrderedJson json = {{"kind", table.kind},
                      {"unit", table.unit},
                      {"setting", table.setting},
                      {"values", OrderedJson::array()}};
  for (const CalibrationRow& row : table.rows) {
    OrderedJson entry = {{"label", row.label}, {"value", row.value}, {"object", row.object}};
    if (row.to_mm > 0) {
      entry["from_mm"] = row.from_mm;
      entry["to_mm"] = row.to_mm;
    }
    json["values"].push_back(std::move(entry));
  }
  return json;
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
  if (report.own) report.own->AddTo(json);
  AddShares(report.shares, json);
  if (!context.calibration.kind.empty()) json["calibration"] = ToJson(context.calibration);
  json["stage_times_s"] = ToJson(report.stage_times);
  json["warnings"] = report.warnings;
  json["notes"] = report.notes;
  json["settings_without_effect"] = context.settings_without_effect;
  json["settings_digest"] = context.settings_digest;
  json["build_id"] = context.build_id;
  for (const SettingSource& each : context.sources)
    json["setting_sources"].push_back({{"source", each.source}, {"keys", each.keys}});
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace slicefarm::coordinator
