#include "common/config/projects/orca_gcode.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "common/base/text.h"

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

/// Adds the speed of the fan beside the bed, if the machine has one: off on the first layers, then
/// a constant speed.
void AddAuxiliaryFan(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  constexpr std::string_view kSpeed = "additional_cooling_fan_speed";
  const double percent = NumberOr(given, kSpeed, 0);
  const bool has_fan = given("auxiliary_fan") == "1";
  if (!has_fan || !(percent > 0)) return;
  const auto off = static_cast<int>(NumberOr(given, "close_fan_the_first_x_layers", 0));
  added.push_back({.key = "layer_gcode",
                   .lines = fmt::format("{{if layer_num=={}}}M106 P2 S{}\\n{{endif}}",
                                        std::max(0, off), StepsOf(percent)),
                   .in_front = true,
                   .because = kSpeed});
  added.push_back(
      {.key = "end_gcode", .lines = "M106 P2 S0\\n", .in_front = true, .because = kSpeed});
}

/// Adds the speeds of the chamber's exhaust fan during and after a print that filters its air.
void AddExhaustFan(const OrcaLookup& given, std::vector<AddedGcode>& added) {
  constexpr std::string_view kOn = "activate_air_filtration";
  constexpr double kDuring = 60, kAfter = 80;
  const bool on = given(kOn) == "1";
  const double during = NumberOr(given, "during_print_exhaust_fan_speed", kDuring);
  const double after = NumberOr(given, "complete_print_exhaust_fan_speed", kAfter);
  if (!on) return;
  for (const auto& [key, percent] : {std::pair("start_gcode", during), {"end_gcode", after}})
    added.push_back(
        {.key = key, .lines = fmt::format("M106 P3 S{}\\n", StepsOf(percent)), .because = kOn});
}

}  // namespace

std::vector<AddedGcode> AddedGcodeOf(const OrcaLookup& given) {
  std::vector<AddedGcode> added;
  AddFirstLayerScan(given, added);
  AddAuxiliaryFan(given, added);
  AddExhaustFan(given, added);
  return added;
}

std::string WithGcode(std::string_view lines, const AddedGcode& added) {
  if (added.in_front) return added.lines + std::string(lines);
  const bool open_end = !lines.empty() && !lines.ends_with("\\n");
  return std::string(lines) + (open_end ? "\\n" : "") + added.lines;
}

}  // namespace slicefarm::config
