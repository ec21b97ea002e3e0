#include "common/gcode/archive/plate_texts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/base/text.h"
#include "common/base/utf8.h"

namespace slicefarm::gcode {
namespace {

using PlateJsonValue = nlohmann::ordered_json;

/// Version of Bambu Studio that has the format of the archive. Printers and programs compare it.
constexpr std::string_view kFormatVersion = "02.00.00.00";
constexpr std::string_view kXmlHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr double kMmPerM = 1000;

/// Returns the text for an attribute or for the text of an element.
std::string XmlText(std::string_view text) {
  constexpr size_t kMostBytes = 4'096;
  std::string escaped;
  for (const char c : ReplaceControls(ToUtf8(text, kMostBytes), ' ')) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string Meta(std::string_view key, std::string_view value) {
  return fmt::format("    <metadata key=\"{}\" value=\"{}\"/>\n", key, XmlText(value));
}

std::string_view Flag(bool on) { return on ? "true" : "false"; }

std::string NumberedName(std::string_view name, int number) {
  std::string text = "Metadata/";
  for (const char c : name) {
    if (c == '#') {
      text += std::to_string(number);
    } else {
      text += c;
    }
  }
  return text;
}

PlateJsonValue BoxJson(const BedBox& box) { return {box.min_x, box.min_y, box.max_x, box.max_y}; }

/// Returns the box around all objects; empty if there are none.
BedBox BoxOfAll(const std::vector<ArchivedObject>& objects) {
  if (objects.empty()) return {};
  BedBox all = objects.front().box;
  for (const ArchivedObject& object : objects)
    all = {std::min(all.min_x, object.box.min_x), std::min(all.min_y, object.box.min_y),
           std::max(all.max_x, object.box.max_x), std::max(all.max_y, object.box.max_y)};
  return all;
}

std::string Dumped(const PlateJsonValue& json, int indent) {
  return json.dump(indent, ' ', false, PlateJsonValue::error_handler_t::replace);
}

}  // namespace

std::string SliceInfoPlate(const ArchivedPlate& plate, int number) {
  const std::string nozzle = fmt::format("{:g}", plate.nozzle_mm);
  std::string xml = "  <plate>\n" + Meta("index", std::to_string(number)) +
                    Meta("extruder_type", "0") + Meta("nozzle_volume_type", "0") +
                    Meta("printer_model_id", PrinterModelId(plate.printer_model)) +
                    Meta("nozzle_diameters", nozzle) + Meta("timelapse_type", "0") +
                    Meta("prediction", std::to_string(std::lround(plate.time_s))) +
                    Meta("weight", fmt::format("{:.2f}", plate.filament_g)) +
                    Meta("first_layer_time", fmt::format("{:.6f}", plate.first_layer_time_s)) +
                    Meta("outside", "false") + Meta("support_used", Flag(plate.has_supports)) +
                    Meta("label_object_enabled", Flag(plate.has_labels)) +
                    Meta("filament_maps", "1") + Meta("limit_filament_maps", "0");
  for (const ArchivedObject& object : plate.objects)
    xml += fmt::format("    <object identify_id=\"{}\" name=\"{}\" skipped=\"false\" />\n",
                       object.id, XmlText(object.name));
  xml += fmt::format(
      "    <filament id=\"1\" tray_info_idx=\"{}\" type=\"{}\" color=\"{}\" used_m=\"{:.2f}\" "
      "used_g=\"{:.2f}\" group_id=\"0\" nozzle_diameter=\"{:.2f}\" volume_type=\"Standard\"/>\n",
      XmlText(plate.filament_id), XmlText(plate.filament_type), XmlText(plate.filament_colour),
      plate.filament_mm / kMmPerM, plate.filament_g, plate.nozzle_mm);
  for (const std::string& warning : plate.warnings)
    xml +=
        fmt::format("    <warning msg=\"{}\" level=\"1\" error_code =\"\"  />\n", XmlText(warning));
  xml += fmt::format(
      "    <layer_filament_lists>\n      <layer_filament_list filament_list=\"0\" "
      "layer_ranges=\"0 {}\" />\n    </layer_filament_lists>\n  </plate>\n",
      std::max<int64_t>(plate.layers - 1, 0));
  return xml;
}

std::string ModelSettingsPlate(int number, std::string_view title) {
  const auto file = [&](std::string_view key, std::string_view name) {
    return Meta(key, NumberedName(name, number));
  };
  return "  <plate>\n" + Meta("plater_id", std::to_string(number)) + Meta("plater_name", title) +
         Meta("locked", "false") + Meta("filament_map_mode", "Auto For Flush") +
         Meta("filament_maps", "1") + Meta("filament_volume_maps", "0") +
         file("gcode_file", "plate_#.gcode") + file("thumbnail_file", "plate_#.png") +
         file("thumbnail_no_light_file", "plate_no_light_#.png") + file("top_file", "top_#.png") +
         file("pick_file", "pick_#.png") + file("pattern_bbox_file", "plate_#.json") +
         "  </plate>\n";
}

std::string PlateJson(const ArchivedPlate& plate) {
  PlateJsonValue objects = PlateJsonValue::array();
  for (const ArchivedObject& object : plate.objects)
    objects.push_back({{"area", object.area_mm2},
                       {"bbox", BoxJson(object.box)},
                       {"id", object.id},
                       {"layer_height", plate.layer_height_mm},
                       {"name", object.name}});
  PlateJsonValue json = {{"bbox_all", BoxJson(BoxOfAll(plate.objects))},
                         {"bbox_objects", std::move(objects)},
                         {"filament_colors", {plate.filament_colour}},
                         {"filament_ids", {0}},
                         {"first_extruder", 0},
                         {"first_layer_time", plate.first_layer_time_s},
                         {"is_seq_print", plate.one_by_one},
                         {"nozzle_diameter", plate.nozzle_mm},
                         {"version", 2}};
  if (!plate.bed_type.empty()) json["bed_type"] = plate.bed_type;
  return Dumped(json, -1);
}

std::string ProjectSettingsJson(const ArchivedPlate& plate) {
  PlateJsonValue json = PlateJsonValue::object();
  for (const auto& [key, value] : plate.settings) json[key] = value;
  for (const auto& [key, values] : plate.list_settings) json[key] = values;
  return Dumped(json, 4) + "\n";
}

std::string SliceInfoDocument(std::string_view plates) {
  return fmt::format(
      "{}<config>\n  <header>\n    <header_item key=\"X-BBL-Client-Type\" value=\"slicer\"/>\n    "
      "<header_item key=\"X-BBL-Client-Version\" value=\"{}\"/>\n  </header>\n{}</config>\n",
      kXmlHead, kFormatVersion, plates);
}

std::string ModelSettingsDocument(std::string_view plates) {
  return fmt::format("{}<config>\n{}</config>\n", kXmlHead, plates);
}

std::string ModelSettingsRelations(int count) {
  std::string xml(kXmlHead);
  xml += "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";
  for (int number = 1; number <= count; ++number)
    xml += fmt::format(
        " <Relationship Target=\"/Metadata/plate_{0}.gcode\" Id=\"rel-{0}\" "
        "Type=\"http://schemas.bambulab.com/package/2021/gcode\"/>\n",
        number);
  return xml + "</Relationships>\n";
}

std::string ModelDocument(std::string_view title) {
  return fmt::format(
      "{}<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:BambuStudio=\"http://schemas.bambulab.com/package/2021\">\n"
      " <metadata name=\"Application\">BambuStudio-{}</metadata>\n"
      " <metadata name=\"BambuStudio:3mfVersion\">1</metadata>\n"
      " <metadata name=\"Title\">{}</metadata>\n <resources>\n </resources>\n <build/>\n</model>\n",
      kXmlHead, kFormatVersion, XmlText(title));
}

std::string ContentTypesDocument() {
  return std::string(kXmlHead) +
         "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
         " <Default Extension=\"rels\" "
         "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
         " <Default Extension=\"model\" "
         "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
         " <Default Extension=\"png\" ContentType=\"image/png\"/>\n"
         " <Default Extension=\"gcode\" ContentType=\"text/x.gcode\"/>\n</Types>\n";
}

std::string RelationsDocument() {
  constexpr std::string_view kParts[][2] = {
      {"/3D/3dmodel.model", "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"},
      {"/Metadata/plate_1.png",
       "http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"},
      {"/Metadata/plate_1.png", "http://schemas.bambulab.com/package/2021/cover-thumbnail-middle"},
      {"/Metadata/plate_1_small.png",
       "http://schemas.bambulab.com/package/2021/cover-thumbnail-small"}};
  std::string xml(kXmlHead);
  xml += "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";
  int id = 0;
  for (const auto& [target, type] : kParts)
    xml += fmt::format(" <Relationship Target=\"{}\" Id=\"rel-{}\" Type=\"{}\"/>\n", target, ++id,
                       type);
  return xml + "</Relationships>\n";
}

std::string_view PrinterModelId(std::string_view printer_model) {
  // Sources: model_id of the machines in Bambu Studio's profiles.
  constexpr std::pair<std::string_view, std::string_view> kIds[] = {
      {"Bambu Lab A1", "N2S"},
      {"Bambu Lab A1 mini", "N1"},
      {"Bambu Lab H2D", "O1D"},
      {"Bambu Lab P1P", "C11"},
      {"Bambu Lab P1S", "C12"},
      {"Bambu Lab X1", "BL-P002"},
      {"Bambu Lab X1 Carbon", "BL-P001"},
      {"Bambu Lab X1E", "C13"},
  };
  const auto found =
      std::ranges::find(kIds, printer_model, [](const auto& id) { return id.first; });
  return found == std::end(kIds) ? "" : found->second;
}

}  // namespace slicefarm::gcode
