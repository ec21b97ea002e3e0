#include "services/cli/program/klipper_config.h"

#include <fmt/core.h>

#include <map>
#include <numbers>
#include <string>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/options/tool_row.h"

namespace slicefarm::cli {
namespace {

/// Numbers by `section.key`.
class Values {
 public:
  explicit Values(std::string_view text) {
    std::string section;
    for (std::string_view line : Split(text, "\n")) {
      const bool indented = line.starts_with(' ') || line.starts_with('\t');
      line = Trim(line.substr(0, line.find_first_of("#;")));
      if (line.starts_with('[') && line.ends_with(']')) {
        section = std::string(Trim(line.substr(1, line.size() - 2)));
        continue;
      }
      const size_t sign = line.find_first_of(":=");
      if (indented || sign == line.npos) continue;
      texts_[section + "." + std::string(Trim(line.substr(0, sign)))] =
          std::string(Trim(line.substr(sign + 1)));
    }
  }

  double Number(const std::string& key, double otherwise) {
    const auto found = texts_.find(key);
    if (found == texts_.end()) return otherwise;
    const auto number = ToNumber(found->second);
    if (!number && wrong_.empty()) wrong_ = key;
    return number.value_or(otherwise);
  }
  double Required(const std::string& key) {
    if (!texts_.contains(key) && wrong_.empty()) wrong_ = key;
    return Number(key, 1);
  }
  const std::string& wrong() const { return wrong_; }

 private:
  std::map<std::string, std::string, std::less<>> texts_;
  std::string wrong_;
};

void ReadPrinter(Values& values, MachineLimits& limits) {
  const double velocity = values.Required("printer.max_velocity");
  const double accel = values.Required("printer.max_accel");
  limits.max_feedrate_mm_s[kX] = limits.max_feedrate_mm_s[kY] = velocity;
  limits.max_feedrate_mm_s[kZ] = values.Number("printer.max_z_velocity", velocity);
  limits.max_acceleration_mm_s2[kX] = limits.max_acceleration_mm_s2[kY] = accel;
  limits.max_acceleration_mm_s2[kZ] = values.Number("printer.max_z_accel", accel);
  limits.max_acceleration_extruding_mm_s2 = limits.max_acceleration_travel_mm_s2 = accel;
  limits.square_corner_velocity_mm_s = values.Number("printer.square_corner_velocity", 5);
  limits.minimum_cruise_ratio = values.Number("printer.minimum_cruise_ratio", 0.5);
}

void ReadExtruder(Values& values, motion::CheckSetup& setup) {
  setup.nozzle_mm = values.Number("extruder.nozzle_diameter", setup.nozzle_mm);
  setup.filament_mm = values.Number("extruder.filament_diameter", setup.filament_mm);
  const double filament_mm2 = std::numbers::pi / 4 * setup.filament_mm * setup.filament_mm;
  // Klipper's default: the filament speed of the widest bead at the toolhead's greatest speed.
  const double ratio = 4 * setup.nozzle_mm * setup.nozzle_mm / filament_mm2;
  MachineLimits& limits = setup.machine.limits;
  limits.max_feedrate_mm_s[kE] =
      values.Number("extruder.max_extrude_only_velocity", limits.max_feedrate_mm_s[kX] * ratio);
  limits.max_acceleration_mm_s2[kE] =
      values.Number("extruder.max_extrude_only_accel", limits.max_acceleration_mm_s2[kX] * ratio);
  limits.max_acceleration_retracting_mm_s2 = 0;
}

void ReadRetraction(Values& values, RetractionOptions& retraction) {
  retraction.length_mm = values.Number("firmware_retraction.retract_length", 0);
  retraction.speed_mm_s = values.Number("firmware_retraction.retract_speed", 20);
  retraction.restart_extra_mm = values.Number("firmware_retraction.unretract_extra_length", 0);
  retraction.restart_speed_mm_s = values.Number("firmware_retraction.unretract_speed", 10);
  retraction.lift_mm = 0;
}

void ReadSpace(Values& values, motion::CheckSetup& setup) {
  const Point low = {FromMm(values.Number("stepper_x.position_min", 0)),
                     FromMm(values.Number("stepper_y.position_min", 0))};
  const Point high = {FromMm(values.Number("stepper_x.position_max", 0)),
                      FromMm(values.Number("stepper_y.position_max", 0))};
  if (high.x > low.x && high.y > low.y) setup.bed = {low, {high.x, low.y}, high, {low.x, high.y}};
  setup.max_height_mm = values.Number("stepper_z.position_max", 0);
  setup.z_offset_mm = values.Number("stepper_z.position_min", 0);
}

}  // namespace

bool IsKlipperConfig(std::string_view text) {
  for (const std::string_view line : Split(text, "\n"))
    if (Trim(line).starts_with("[printer]")) return true;
  return false;
}

absl::StatusOr<motion::CheckSetup> ReadKlipperConfig(std::string_view text) {
  Values values(text);
  motion::CheckSetup setup;
  ReadPrinter(values, setup.machine.limits);
  ReadExtruder(values, setup);
  ReadRetraction(values, setup.machine.retraction);
  ReadSpace(values, setup);
  setup.machine.arc_segment_mm = values.Number("gcode_arcs.resolution", 1);
  if (!values.wrong().empty()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                     fmt::format("{}: is missing or not a number", values.wrong()),
                     {{"setting", values.wrong()}});
  }
  return setup;
}

}  // namespace slicefarm::cli
