#include "services/motion/algo/gcode/print_metadata.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/build_info.h"
#include "common/base/duration_text.h"
#include "common/gcode/archive/project_keys.h"
#include "common/gcode/gcode_text.h"
#include "common/macro/settings_text.h"
#include "common/model/layers/filament_use.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/text/comment_text.h"

namespace slicefarm::motion {
namespace {

std::string Number(double value, int digits) {
  GcodeText text;
  text.Real(value, digits);
  return text.Take();
}

void Line(std::string_view key, const std::string& value, GcodeText& out) {
  out << "; " << key << " = " << value << '\n';
}

/// Writes the filament that the print uses, and its costs. `time_s`: time of the print, for the
/// cost of the printer.
void WriteUse(const MotionOptions& options, const ProgramStats& total, double time_s,
              GcodeText& out) {
  const FilamentUse use = FilamentUseOf(total, options);
  Line("filament used [mm]", Number(use.length_mm, 2), out);
  Line("filament used [cm3]", Number(use.volume_mm3 / 1000, 2), out);
  Line("filament used [g]", Number(use.mass_g, 2), out);
  Line("filament cost", Number(use.cost, 2), out);
  Line("total filament used [g]", Number(use.mass_g, 2), out);
  Line("total filament cost", Number(use.cost + PrinterCost(options, time_s), 2), out);
}

void WriteTimes(std::string_view mode, const PrintTimes& times, GcodeText& out) {
  const auto line = [&](std::string_view what, double time_s) {
    out << "; estimated " << what << "printing time (" << mode
        << " mode) = " << DurationText(time_s) << '\n';
  };
  line("", times.TotalS());
  if (!times.layer_s.empty()) line("first layer ", times.layer_s.front());
}

void WriteLayers(const ProgramSummary& summary, const PrintTimes& times,
                 const std::optional<PrintTimes>& silent, GcodeText& out) {
  Line("total toolchanges", "0", out);
  Line("total layers count", std::to_string(summary.layers.size()), out);
  WriteTimes("normal", times, out);
  if (silent) WriteTimes("silent", *silent, out);
  if (summary.layers.empty()) return;
  Line("max_layer_z", Number(ToMm(static_cast<double>(TopOf(summary))), 3), out);
}

using Setting = std::pair<std::string_view, std::string>;

std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : OneLine(text)) {
    if (c == '"') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

/// Keys that hosts search for, with the values that are written if the settings lack them. The
/// values mean: one tool, and none of these features.
constexpr std::pair<std::string_view, std::string_view> kUnlessGiven[] = {
    {"brim_width", "0"},        {"chamber_temperature", "0"},
    {"filament_abrasive", "0"}, {"ironing", "0"},
    {"nozzle_high_flow", "0"},  {"printer_variant", "\"\""},
    {"printer_vendor", "\"\""}, {"profile_version", "\"\""},
    {"referenced_tools", "0"},  {"single_extruder_multi_material", "0"},
    {"support_material", "0"},
};

/// Returns the keys that hosts search for, with values from the options.
std::vector<Setting> KnownSettings(const MotionOptions& options, const ProgramSummary& summary) {
  std::vector<Setting> settings;
  const auto height = [&](size_t layer) {
    return Number(ToMm(static_cast<double>(summary.layers[layer].frame.height_nm)), 3);
  };
  if (!summary.layers.empty()) {
    settings.emplace_back("layer_height", height(summary.layers.size() > 1 ? 1 : 0));
    settings.emplace_back("first_layer_height", height(0));
  }
  settings.emplace_back("nozzle_diameter", Number(options.tool().nozzle_diameter_mm, 3));
  settings.emplace_back("temperature", std::to_string(options.tool().temperature_c));
  settings.emplace_back("first_layer_temperature",
                        std::to_string(options.tool().first_layer_temperature_c));
  settings.emplace_back("bed_temperature", std::to_string(options.tool().bed_temperature_c));
  settings.emplace_back("first_layer_bed_temperature",
                        std::to_string(options.tool().first_layer_bed_temperature_c));
  settings.emplace_back("filament_type", OneLine(options.tool().filament_type));
  settings.emplace_back("filament_colour", OneLine(options.tool().filament_colour));
  settings.emplace_back("extruder_colour", OneLine(options.tool().filament_colour));
  settings.emplace_back("filament_settings_id", Quoted(options.tool().filament_settings_id));
  settings.emplace_back("printer_model", OneLine(options.printer_model));
  for (const auto& [key, value] : kUnlessGiven) settings.emplace_back(key, value);
  return settings;
}

/// Returns the settings ordered by key. So a file keeps this order if its settings are read back
/// from it.
std::map<std::string, std::string, std::less<>> AllSettings(const MotionOptions& options,
                                                            const ProgramSummary& summary) {
  std::map<std::string, std::string, std::less<>> settings;
  for (const auto& [key, value] : macro::SettingLines(summary.settings_text))
    settings.emplace(CommentLine(key), CommentLine(value));
  for (const auto& [key, value] : KnownSettings(options, summary))
    if (!value.empty()) settings.emplace(key, value);
  return settings;
}

void WriteSettings(const MotionOptions& options, const ProgramSummary& summary, GcodeText& out) {
  out << "\n; prusaslicer_config = begin\n";
  for (const auto& [key, value] : AllSettings(options, summary)) Line(key, value, out);
  out << "; prusaslicer_config = end\n";
}

}  // namespace

namespace {

/// Writes the corners in mm; nothing if they are not known.
void WritePolygon(const Polygon& polygon, GcodeText& out) {
  if (polygon.empty()) return;
  std::string_view before = ",\"polygon\":[[";
  for (const Point corner : polygon) {
    out << before;
    out.Mm(corner.x, 3) << ',';
    out.Mm(corner.y, 3);
    before = "],[";
  }
  out << "]]";
}

}  // namespace

std::string MetadataHead(const ProgramSummary& summary) {
  GcodeText out;
  out << "; generated by slicefarm " << Version() << " on " << ReleaseDate()
      << " at 00:00:00 UTC\n;\n";
  if (summary.copies.empty()) return out.Take();
  out << "; objects_info = {\"objects\":[";
  std::string_view comma;
  for (const CopySummary& copy : summary.copies) {
    out << comma << "{\"name\":" << JsonString(copy.name.object_name);
    WritePolygon(copy.footprint, out);
    out << '}';
    comma = ",";
  }
  out << "]}\n;\n";
  return out.Take();
}

std::string ArchiveConfigBlock(const MotionOptions& options, const ProgramSummary& summary) {
  const auto settings = AllSettings(options, summary);
  GcodeText out;
  out << "; CONFIG_BLOCK_START\n";
  for (const gcode::ProjectKey& key : gcode::kProjectKeys)
    if (const auto found = settings.find(key.key); found != settings.end())
      Line(key.name, found->second, out);
  out << "; CONFIG_BLOCK_END\n\n";
  return out.Take();
}

std::string MetadataTail(const MotionOptions& options, const ProgramSummary& summary,
                         const PrintTimes& times, const std::optional<PrintTimes>& silent) {
  GcodeText out;
  out << '\n';
  WriteUse(options, summary.total, times.TotalS(), out);
  WriteLayers(summary, times, silent, out);
  WriteSettings(options, summary, out);
  return out.Take();
}

}  // namespace slicefarm::motion
