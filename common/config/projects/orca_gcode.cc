#include "common/config/projects/orca_gcode.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "absl/strings/ascii.h"
#include "common/base/text.h"
#include "common/model/limits.h"

namespace slicefarm::config {
namespace {

/// Returns the first value of a setting as a number, or `otherwise` if it is missing or no number.
double NumberOr(const OrcaLookup& given, std::string_view key, double otherwise) {
  const std::optional<std::string> text = given(key);
  return text ? ToNumber(Trim(std::string_view(*text).substr(0, text->find('%'))))
                    .value_or(otherwise)
              : otherwise;
}

/// Returns a fan speed in the steps of M106, rounded down as in OrcaSlicer.
int StepsOf(double percent) {
  return static_cast<int>(255 * std::clamp(percent, 0.0, 100.0) / 100);
}

/// Adds the inspection of the first layer before the second one, on machines with a scanner.
void AddFirstLayerScan(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  const bool on = given("scan_first_layer") == "1";
  if (!on || !IsBambuMachine(given)) return;
  added.push_back({.key = "layer_gcode",
                   .lines = "{if layer_num==1}M976 S1 P1 ; scan model before printing 2nd "
                            "layer\\nM400 P100\\n{endif}",
                   .because = "scan_first_layer"});
}

/// Returns a number of layers, limited to the layers that a job may have.
int LayersOr(const OrcaLookup& given, std::string_view key, double standard) {
  constexpr double kMost = limits::kMaxLayers;
  return static_cast<int>(std::clamp(NumberOr(given, key, standard), 0.0, kMost));
}

std::string Lower(std::string_view text) {
  return absl::AsciiStrToLower({text.data(), text.size()});
}

/// Returns G-code for a layer.
std::string AtLayer(int layer, std::string_view lines) {
  return fmt::format("{{if layer_num=={}}}{}\\n{{endif}}", layer, lines);
}

/// Adds the speed of the fan beside the bed, if the machine has one: first_x_layer_fan_speed on the
/// first layers, then a rise to its speed up to additional_fan_full_speed_layer. Machines of Bambu
/// Lab set this speed in layer_change_gcode. Older presets have close_fan_the_first_x_layers
/// instead of close_additional_fan_first_x_layers.
void AddAuxiliaryFan(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  constexpr std::string_view kSpeed = "additional_cooling_fan_speed";
  constexpr std::string_view kLayers = "close_additional_fan_first_x_layers";
  const double percent = NumberOr(given, kSpeed, 0);
  const double first = NumberOr(given, "first_x_layer_fan_speed", 0);
  const bool has_fan = given("auxiliary_fan") == "1";
  const int off = LayersOr(given, kLayers, NumberOr(given, "close_fan_the_first_x_layers", 0));
  const int full = LayersOr(given, "additional_fan_full_speed_layer", 0);
  if (!has_fan || !(percent > 0)) return;
  std::string lines;
  const auto set = [&](int layer, double speed) {
    lines += AtLayer(layer, fmt::format("M106 P2 S{}", StepsOf(speed)));
  };
  if (off > 0 && first > 0) set(0, first);
  for (int layer = off; layer + 1 < full; ++layer)
    set(layer, first + (percent - first) * (layer + 1 - off) / (full - off));
  set(std::max(off, full - 1), percent);
  added.push_back({.key = "layer_gcode", .lines = lines, .in_front = true, .because = kSpeed});
  added.push_back(
      {.key = "end_gcode", .lines = "M106 P2 S0\\n", .in_front = true, .because = kSpeed});
}

/// Adds the speeds of the chamber's exhaust fan during and after a print that filters its air.
void AddExhaustFan(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  constexpr std::string_view kOn = "activate_air_filtration";
  constexpr double kDuring = 60, kAfter = 80;
  const bool on = given(kOn) == "1";
  struct Fan {
    std::string_view key, on, speed;
    double standard;
  };
  for (const Fan& fan : {Fan{"start_gcode", "activate_air_filtration_during_print",
                             "during_print_exhaust_fan_speed", kDuring},
                         Fan{"end_gcode", "activate_air_filtration_on_completion",
                             "complete_print_exhaust_fan_speed", kAfter}}) {
    const bool off = given(fan.on) == "0";
    const double percent = NumberOr(given, fan.speed, fan.standard);
    if (on && !off)
      added.push_back({.key = fan.key,
                       .lines = fmt::format("M106 P3 S{}\\n", StepsOf(percent)),
                       .because = kOn});
  }
}

/// Adds the input shaper of an axis, for Klipper or Marlin.
void AddShaper(const OrcaLookup& given, std::string_view axis, std::string_view type,
               std::string& lines) {
  const double hz = NumberOr(given, fmt::format("input_shaping_freq_{}", axis), 0);
  const double damping = NumberOr(given, fmt::format("input_shaping_damp_{}", axis), 0.1);
  const std::string name = axis == "x" ? "X" : "Y";
  const bool klipper = given("gcode_flavor") == "klipper";
  const bool off = type == "Disable";
  std::string words;
  if (klipper) {
    if (!off && type != "Default" && !type.empty())
      words += fmt::format(" SHAPER_TYPE_{}={}", name, Lower(type));
    if (off || hz > 0) words += fmt::format(" SHAPER_FREQ_{}={}", name, off ? 0 : hz);
    if (!off && damping > 0) words += fmt::format(" DAMPING_RATIO_{}={}", name, damping);
    if (!words.empty()) lines += fmt::format("SET_INPUT_SHAPER{}\\n", words);
    return;
  }
  if (off || hz > 0) words += fmt::format(" F{}", off ? 0 : hz);
  if (!off && damping > 0) words += fmt::format(" D{}", damping);
  if (!words.empty()) lines += fmt::format("M593 {}{}\\n", name, words);
}

/// Adds the input shapers after the start code: SET_INPUT_SHAPER of Klipper, M593 of Marlin 2 and
/// of RepRapFirmware, which has one for both axes. 0 leaves a value to the firmware.
void AddInputShaping(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  constexpr std::string_view kOn = "input_shaping_emit";
  const bool on = given(kOn) == "1";
  const std::string type = given("input_shaping_type").value_or("Default");
  const std::string flavor = given("gcode_flavor").value_or("marlin");
  std::string lines;
  if (flavor == "reprapfirmware") {
    const double hz = NumberOr(given, "input_shaping_freq_x", 0);
    const double damping = NumberOr(given, "input_shaping_damp_x", 0.1);
    const bool off = type == "Disable";
    std::string words = off ? " P\"none\"" : "";
    if (!off && type != "Default") words += fmt::format(" P\"{}\"", Lower(type));
    if (!off && hz > 0) words += fmt::format(" F{}", hz);
    if (!off && damping > 0) words += fmt::format(" S{}", damping);
    if (!words.empty()) lines = "M593" + words + "\\n";
  } else if (flavor == "klipper" || flavor == "marlin2") {
    for (const std::string_view axis : {"x", "y"}) AddShaper(given, axis, type, lines);
  }
  if (on && !lines.empty()) added.push_back({.key = "start_gcode", .lines = lines, .because = kOn});
}

/// Adds the command that switches power loss recovery on or off. Machines of Bambu Lab switch it on
/// at the second layer without this setting.
void AddPowerLossRecovery(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  constexpr std::string_view kMode = "enable_power_loss_recovery";
  const std::string mode = given(kMode).value_or("");
  const bool on = mode == "enable" || mode == "1";
  if (!on && mode != "disable") return;
  if (!on && IsBambuMachine(given))
    added.push_back({.key = "layer_gcode", .lines = AtLayer(1, "M1003 S0"), .because = kMode});
  if (given("gcode_flavor") == "marlin2")
    added.push_back(
        {.key = "start_gcode", .lines = on ? "M413 S1\\n" : "M413 S0\\n", .because = kMode});
}

}  // namespace

std::vector<AddedGcode> AddedGcodeOf(const OrcaLookup& given) {
  std::vector<AddedGcode> added;
  AddFirstLayerScan(given, added);
  AddAuxiliaryFan(given, added);
  AddExhaustFan(given, added);
  AddInputShaping(given, added);
  AddPowerLossRecovery(given, added);
  return added;
}

std::string WithGcode(std::string_view lines, const AddedGcode& added) {
  if (added.in_front) return added.lines + std::string(lines);
  const bool open_end = !lines.empty() && !lines.ends_with("\\n");
  return std::string(lines) + (open_end ? "\\n" : "") + added.lines;
}

}  // namespace slicefarm::config
