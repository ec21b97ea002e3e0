#include "common/config/projects/orca_dialect.h"

#include <fmt/core.h>

#include "common/config/table/value.h"
#include "common/geometry/measure.h"

namespace slicefarm::config {
namespace {

/// Returns true if OrcaSlicer writes limits for this firmware.
bool IsMarlinOrRepRap(std::string_view flavor) {
  return flavor == "marlin" || flavor == "marlin2" || flavor == "reprapfirmware";
}

}  // namespace

bool IsBambuMachine(const OrcaLookup& given) {
  return given("printer_model").value_or("").starts_with("Bambu Lab");
}

std::vector<Setting> DialectOf(const OrcaLookup& given) {
  std::vector<Setting> settings;
  const auto set = [&](std::string_view key, std::string_view value) {
    settings.push_back({std::string(key), std::string(value), Source::kProfile});
  };
  const bool bambu = IsBambuMachine(given);
  const std::string flavor = given("gcode_flavor").value_or("marlin");
  if (bambu && flavor == "marlin") set("gcode_flavor", "bambu");
  if (given("exclude_object") == "1" || bambu) set("gcode_label_objects", "firmware");
  const std::optional<std::string> no_m73 = given("disable_m73");
  if (no_m73 == "0" || (bambu && no_m73 != "1")) set("remaining_times", "1");
  // Projects of Bambu Studio and of older versions of OrcaSlicer have limits, but lack this
  // setting.
  if (IsMarlinOrRepRap(flavor) && given("machine_max_speed_x"))
    set("machine_limits_usage",
        given("emit_machine_limits_to_gcode") == "0" ? "time_estimate_only" : "emit_to_gcode");
  // Without this setting the temperature would only be a variable of templates.
  if (given("chamber_temperature").value_or("0") != "0")
    set("activate_chamber_temp_control", given("activate_chamber_temp_control") == "1" ? "1" : "0");
  return settings;
}

std::string HeadWrapExpression(std::string_view zone) {
  const auto areas = ParseAreas(zone);
  if (!areas.ok() || areas->empty()) return "false";
  const Box box = Bounds(areas->front());
  const auto mm = [](Coord nm) { return PrintNumber(ToMm(static_cast<double>(nm))); };
  return fmt::format(
      "(first_layer_print_max[0] > {} and first_layer_print_min[0] < {} and "
      "first_layer_print_max[1] > {} and first_layer_print_min[1] < {})",
      mm(box.min.x), mm(box.max.x), mm(box.min.y), mm(box.max.y));
}

}  // namespace slicefarm::config
