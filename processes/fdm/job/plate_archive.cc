#include "processes/fdm/job/plate_archive.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "common/base/text.h"
#include "common/gcode/archive/project_keys.h"
#include "common/geometry/measure.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kSmallPicturePx = 128;
constexpr double kNm2PerMm2 = 1e12;

std::string NameOf(const Thumbnail& picture) {
  switch (picture.role) {
    case PictureRole::kUnlit:
      return "plate_no_light_#.png";
    case PictureRole::kTop:
      return "top_#.png";
    case PictureRole::kPick:
      return "pick_#.png";
    case PictureRole::kProgram:
    case PictureRole::kPlate:
      break;
  }
  return picture.width_px <= kSmallPicturePx ? "plate_#_small.png" : "plate_#.png";
}

gcode::ArchivedObject ObjectOf(const CopySummary& copy, int32_t index) {
  gcode::ArchivedObject object;
  object.id = PickId(index);
  object.name = copy.name.object_name;
  if (copy.footprint.empty()) return object;
  const Box box = Bounds(copy.footprint);
  const auto mm = [](Coord nm) { return ToMm(static_cast<double>(nm)); };
  object.box = {mm(box.min.x), mm(box.min.y), mm(box.max.x), mm(box.max.y)};
  object.area_mm2 = std::abs(SignedArea(copy.footprint)) / kNm2PerMm2;
  return object;
}

/// Returns the name of the file without its endings.
std::string TitleOf(std::string_view file_name) {
  for (const std::string_view ending : {".3mf", ".gcode"})
    if (file_name.ends_with(ending)) file_name.remove_suffix(ending.size());
  return std::string(file_name);
}

std::map<std::string, std::string, std::less<>> ValuesOf(std::string_view settings_text) {
  constexpr std::string_view kEquals = " = ";
  std::map<std::string, std::string, std::less<>> values;
  for (const std::string_view line : Split(settings_text, "\n"))
    if (const size_t at = line.find(kEquals); at != line.npos)
      values.emplace(line.substr(0, at), line.substr(at + kEquals.size()));
  return values;
}

/// Returns the name that archives have for the plate on the bed; empty if it has none.
std::string BedTypeOf(std::string_view setting) {
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {
      {"Cool Plate", "cool_plate"},
      {"Engineering Plate", "eng_plate"},
      {"High Temp Plate", "hot_plate"},
      {"Textured PEI Plate", "textured_plate"},
      {"Textured Cool Plate", "textured_cool_plate"},
      {"Supertack Plate", "supertack_plate"}};
  for (const auto& [name, of_archive] : kNames)
    if (name == setting) return std::string(of_archive);
  return "";
}

void AddSettings(std::string_view settings_text, gcode::ArchivedPlate& plate) {
  auto values = ValuesOf(settings_text);
  values["printer_model"] = plate.printer_model;
  values["filament_type"] = plate.filament_type;
  values["filament_colour"] = plate.filament_colour;
  if (const auto id = values.find("filament_id"); id != values.end())
    plate.filament_id = id->second;
  if (const auto bed = values.find("curr_bed_type"); bed != values.end())
    plate.bed_type = BedTypeOf(bed->second);
  for (const gcode::ProjectKey& key : gcode::kProjectKeys) {
    const auto found = values.find(key.key);
    if (found == values.end()) continue;
    if (key.is_list) {
      plate.list_settings.emplace_back(key.name, std::vector<std::string>{found->second});
    } else {
      plate.settings.emplace_back(key.name, found->second);
    }
  }
}

}  // namespace

std::vector<Thumbnail> TakePlatePictures(std::vector<Thumbnail>& thumbnails) {
  std::vector<Thumbnail> pictures, program;
  for (Thumbnail& each : thumbnails)
    (each.role == PictureRole::kProgram ? program : pictures).push_back(std::move(each));
  thumbnails = std::move(program);
  return pictures;
}

gcode::ArchivedPlate ArchivedPlateOf(const ProgramSummary& summary, const PrintTimes& times,
                                     const JobReport& report, const FdmSettings& settings,
                                     std::vector<Thumbnail> pictures) {
  const MachineMotion& machine = settings.machine.motion;
  const ToolRow& tool = settings.tools.front();
  gcode::ArchivedPlate plate;
  plate.title = TitleOf(report.file_name);
  plate.time_s = report.print_time_s;
  if (!times.layer_s.empty()) plate.first_layer_time_s = times.layer_s.front();
  plate.layers = report.layer_count;
  plate.filament_mm = report.filament.length_mm;
  plate.filament_g = report.filament.mass_g;
  plate.filament_type = tool.filament_type;
  plate.filament_colour = tool.filament_colour;
  plate.printer_model = machine.printer_model;
  plate.nozzle_mm = tool.nozzle_diameter_mm;
  if (summary.layers.size() > 1)
    plate.layer_height_mm = ToMm(static_cast<double>(summary.layers[1].frame.height_nm));
  for (const Feature feature : {Feature::kSupport, Feature::kSupportInterface})
    plate.has_supports |= summary.total.features[static_cast<size_t>(feature)].length_mm > 0;
  plate.has_labels = machine.labels == ObjectLabels::kFirmware;
  plate.one_by_one = settings.machine.plan.sequence.complete_objects;
  for (size_t i = 0; i < summary.copies.size(); ++i)
    plate.objects.push_back(ObjectOf(summary.copies[i], static_cast<int32_t>(i)));
  plate.warnings = report.warnings;
  for (Thumbnail& picture : pictures) {
    std::string name = NameOf(picture);
    plate.pictures.push_back({std::move(name), std::move(picture.data)});
  }
  AddSettings(summary.settings_text, plate);
  return plate;
}

}  // namespace slicefarm::coordinator
