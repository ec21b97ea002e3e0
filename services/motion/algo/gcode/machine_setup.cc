#include "services/motion/algo/gcode/machine_setup.h"

#include <algorithm>
#include <string>

#include "common/base/shared/shared_text.h"
#include "common/base/text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/text/commands.h"

namespace slicefarm::motion {

void WriteMachineLimits(const MotionOptions& options, GcodeText& out) {
  if (options.limits.emit_to_gcode) FirmwareOf(options.flavor).WriteLimits(options.limits, out);
}

void WriteTemperature(std::string_view command, int32_t celsius, GcodeText& out) {
  if (celsius <= 0) return;
  out << command << " S";
  out.Integer(celsius) << '\n';
}

namespace {

/// Selects the tool, unless the start G-code has done so.
void WriteTool(const MotionOptions& options, std::string_view start_gcode, GcodeText& out) {
  const std::string tool = "T" + std::to_string(options.tool().number);
  if (options.tool().number < 0 || Commands(start_gcode, {tool})) return;
  out << tool << '\n';
}

}  // namespace

void WriteStart(const MotionOptions& options, const StartCode& code, GcodeText& out) {
  const bool leaves = !options.emit_temperatures;
  const bool sets_bed = leaves || Commands(code.machine, {"M140", "M190"});
  const bool sets_nozzle = leaves || Commands(code.machine, {"M104", "M109"});
  const bool sets_chamber =
      leaves || !options.heats_chamber || Commands(code.machine, {"M141", "M191"});
  if (!sets_chamber) WriteTemperature("M141", options.tool().chamber_temperature_c, out);
  if (!sets_bed) WriteTemperature("M190", options.tool().first_layer_bed_temperature_c, out);
  if (!sets_nozzle) WriteTemperature("M104", options.tool().first_layer_temperature_c, out);
  out.Lines(code.machine);
  out.Lines(FirmwareOf(options.flavor).comments().start_gcode_end);
  if (!sets_nozzle) WriteTemperature("M109", options.tool().first_layer_temperature_c, out);
  if (!sets_chamber) WriteTemperature("M191", options.tool().chamber_least_c, out);
  if (!sets_chamber) WriteTemperature("M141", options.tool().chamber_temperature_c, out);
  WriteTool(options, code.machine, out);
  out.Lines(code.filament);
}

namespace {

/// Returns the junction deviation of the layers, within the machine's limit; 0: none is set. As in
/// OrcaSlicer, a machine without a limit has none.
double JunctionDeviationOf(const MotionOptions& options) {
  if (!FirmwareOf(options.flavor).HasJunctionDeviation()) return 0;
  return std::min(options.jerk.junction_deviation_mm, options.limits.junction_deviation_mm);
}

bool SetsCruiseRatio(const MotionOptions& options) {
  return options.flavor == GcodeFlavor::kKlipper && options.accel_to_decel > 0;
}

double CruiseRatio(const MotionOptions& options) {
  return 1 - std::min(1.0, options.accel_to_decel);
}

}  // namespace

void WriteLayerLimits(const MotionOptions& options, GcodeText& out) {
  const Firmware& firmware = FirmwareOf(options.flavor);
  if (const double mm = JunctionDeviationOf(options); mm > 0)
    firmware.WriteJunctionDeviation(mm, out);
  if (SetsCruiseRatio(options)) firmware.WriteCruiseRatio(CruiseRatio(options), out);
}

MachineLimits LimitsAfterStart(const MotionOptions& options) {
  const Firmware& firmware = FirmwareOf(options.flavor);
  MachineLimits limits = options.limits;
  for (const SharedText* code : {&options.start_gcode, &options.tool().start_filament_gcode}) {
    for (const std::string_view text : Split(*code, "\n")) {
      const GcodeLine line = ParseGcodeLine(text);
      if (line.fault.empty() && text.find_first_of("{[") == text.npos)
        firmware.ApplyLimits(line, limits);
    }
  }
  if (const double mm = JunctionDeviationOf(options); mm > 0) limits.junction_deviation_mm = mm;
  if (SetsCruiseRatio(options)) limits.minimum_cruise_ratio = CruiseRatio(options);
  if (options.default_acceleration_mm_s2 > 0)
    limits.max_acceleration_extruding_mm_s2 = options.limits.max_acceleration_extruding_mm_s2;
  return limits;
}

}  // namespace slicefarm::motion
