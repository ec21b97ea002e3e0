#include "services/cli/calibration/calibration_kind.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/base/error.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

constexpr CalibrationInfo kInfos[] = {
    {CalibrationKind::kTemperature, "temperature",
     "nozzle temperature: a tower with bridges and overhangs", "°C", 15, -15, 5, 150, 500, 0,
     "temperature", "", true},
    {CalibrationKind::kFlow, "flow",
     "extrusion_multiplier: plates with top surfaces; --fine: in smaller steps", "%", -20, 20, 5,
     -50, 50, 0, "extrusion_multiplier", "", true},
    {CalibrationKind::kPressureAdvance, "pressure-advance",
     "pressure_advance: a tower with sharp corners, lines or a pattern (--method)", "s", 0, 0.1,
     0.01, 0, 2, 3, "pressure_advance", "", true},
    {CalibrationKind::kVolumetricSpeed, "volumetric-speed",
     "filament_max_volumetric_speed: a tower of a single wall", "mm3/s", 5, 20, 1, 0.5, 100, 1,
     "filament_max_volumetric_speed", "", true},
    {CalibrationKind::kRetraction, "retraction", "retract_length: two pillars", "mm", 0, 2, 0.2, 0,
     15, 2, "retract_length", "", true},
    {CalibrationKind::kVfa, "vfa",
     "external_perimeter_speed: a tower with flat walls, which show vertical artefacts", "mm/s", 40,
     200, 10, 5, 1000, 0, "external_perimeter_speed", "", false},
    {CalibrationKind::kCornering, "cornering",
     "jerk or square corner velocity: a tower with sharp corners", "mm/s", 1, 15, 1, 0.1, 50, 1,
     "machine_max_jerk_x", "machine_max_jerk_y", false},
    {CalibrationKind::kInputShaping, "input-shaping",
     "frequency of the input shaper: a tower with sharp corners", "Hz", 15, 110, 5, 5, 500, 0, "",
     "", false},
};

bool IsMarlin(std::string_view flavor) { return flavor == "marlin" || flavor == "marlin2"; }

std::string TemperatureCode(std::string_view /*flavor*/, double value) {
  return fmt::format("M104 S{:g}", value);
}

std::string PressureAdvanceCode(std::string_view flavor, double value) {
  if (flavor == "klipper") return fmt::format("SET_PRESSURE_ADVANCE ADVANCE={:g}", value);
  if (flavor == "reprapfirmware") return fmt::format("M572 D0 S{:g}", value);
  if (flavor == "prusabuddy") return fmt::format("M572 S{:g}", value);
  if (IsMarlin(flavor) || flavor == "bambu") return fmt::format("M900 K{:g}", value);
  return "";
}

std::string RetractionCode(std::string_view flavor, double value) {
  if (flavor == "klipper") return fmt::format("SET_RETRACTION RETRACT_LENGTH={:g}", value);
  if (IsMarlin(flavor) || flavor == "reprapfirmware") return fmt::format("M207 S{:g}", value);
  return "";
}

std::string CorneringCode(std::string_view flavor, double value) {
  constexpr double kPerMinute = 60;
  if (flavor == "klipper")
    return fmt::format("SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY={:g}", value);
  if (flavor == "reprapfirmware") return fmt::format("M566 X{0:g} Y{0:g}", value * kPerMinute);
  if (IsMarlin(flavor) || flavor == "bambu" || flavor == "prusabuddy")
    return fmt::format("M205 X{0:g} Y{0:g}", value);
  return "";
}

std::string InputShapingCode(std::string_view flavor, double value) {
  if (flavor == "klipper")
    return fmt::format("SET_INPUT_SHAPER SHAPER_FREQ_X={0:g} SHAPER_FREQ_Y={0:g}", value);
  if (IsMarlin(flavor) || flavor == "reprapfirmware") return fmt::format("M593 F{:g}", value);
  return "";
}

}  // namespace

std::span<const CalibrationInfo> CalibrationInfos() { return kInfos; }

const CalibrationInfo& InfoOfCalibration(CalibrationKind kind) {
  return *std::ranges::find(kInfos, kind, &CalibrationInfo::kind);
}

const CalibrationInfo* CalibrationNamed(std::string_view name) {
  const CalibrationInfo* found = std::ranges::find(kInfos, name, &CalibrationInfo::name);
  return found == std::end(kInfos) ? nullptr : found;
}

absl::StatusOr<std::vector<double>> LevelsOf(const CalibrationInfo& info, const GivenLevels& given,
                                             double base) {
  const double start = given.start.value_or(info.start + base);
  const double end = given.end.value_or(info.end + base);
  const double step = given.step.value_or(info.step);
  if (!std::isfinite(start) || !std::isfinite(end) || !std::isfinite(step) || step <= 0)
    return Malformed("--step must be above 0, and --start and --end must be numbers");
  if (std::min(start, end) < info.min || std::max(start, end) > info.max)
    return Malformed(
        fmt::format("{} from {:g} to {:g} {}: the values must be between {:g} and {:g}", info.name,
                    start, end, info.unit, info.min, info.max));
  constexpr double kSlack = 1e-6;  // of a step, because 0.1 has no exact value
  const double count = std::floor(std::abs(end - start) / step + kSlack) + 1;
  if (count < 2 || count > kMostLevels)
    return Malformed(
        fmt::format("{} from {:g} to {:g} {} in steps of {:g} gives {:g} values: choose --step for "
                    "2 to {} values",
                    info.name, start, end, info.unit, step, count, kMostLevels));
  std::vector<double> levels;
  for (int i = 0; i < static_cast<int>(count); ++i)
    levels.push_back(start + (end < start ? -step : step) * i);
  return levels;
}

std::string LabelOf(const CalibrationInfo& info, double value) {
  std::string label = fmt::format("{:.{}f}", value, info.decimals);
  if (std::string_view(label).find_first_not_of("-0.") == std::string_view::npos && label[0] == '-')
    label.erase(0, 1);
  if (info.kind == CalibrationKind::kFlow && value > 0) label.insert(0, 1, '+');
  return label;
}

absl::StatusOr<std::string> CodeOf(const CalibrationInfo& info, std::string_view flavor,
                                   double value) {
  std::string code;
  if (info.kind == CalibrationKind::kTemperature) code = TemperatureCode(flavor, value);
  if (info.kind == CalibrationKind::kPressureAdvance) code = PressureAdvanceCode(flavor, value);
  if (info.kind == CalibrationKind::kRetraction) code = RetractionCode(flavor, value);
  if (info.kind == CalibrationKind::kCornering) code = CorneringCode(flavor, value);
  if (info.kind == CalibrationKind::kInputShaping) code = InputShapingCode(flavor, value);
  if (!code.empty()) return code;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNotSupported,
                   fmt::format("calibrate {}: gcode_flavor = {} has no command that changes the "
                               "value during a print, so this test is not possible",
                               info.name, flavor),
                   {{"setting", "gcode_flavor"}, {"value", std::string(flavor)}});
}

}  // namespace slicefarm::cli
