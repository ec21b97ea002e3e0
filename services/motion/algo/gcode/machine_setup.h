#pragma once

#include <string_view>

#include "common/gcode/gcode_text.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Writes the machine's limits for machine_limits_usage = emit_to_gcode: M201, M203, M204 and M205
/// for Marlin, SET_VELOCITY_LIMIT for Klipper. Limits of 0 are not written.
void WriteMachineLimits(const MotionOptions& options, GcodeText& out);

/// Writes `command` with the temperature, such as `M104 S210`. Writes nothing for 0, which leaves
/// the temperature unchanged.
void WriteTemperature(std::string_view command, int32_t celsius, GcodeText& out);

/// G-code before the layers, with filled-in templates.
struct StartCode {
  std::string_view machine;   ///< `start_gcode`
  std::string_view filament;  ///< `start_filament_gcode`
};

/// Writes the commands before the layers:
/// - Wait until the bed is hot. Start to heat nozzle and chamber.
/// - The machine's start G-code.
/// - Wait until nozzle and chamber are hot.
/// - Tool selection, if the machine has several tools.
/// - The filament's start G-code.
///
/// A heating command is left out if the start G-code contains it. Without emit_temperatures, all
/// heating commands are left out. Temperatures that the start G-code sets take effect after the
/// waits. Source: PrusaSlicer.
void WriteStart(const MotionOptions& options, const StartCode& code, GcodeText& out);

/// Writes the limits that the settings give the layers: default_junction_deviation and
/// accel_to_decel. Write it after the start G-code.
void WriteLayerLimits(const MotionOptions& options, GcodeText& out);

/// Returns the limits of the layers: WriteLayerLimits, and limits in the start G-code (M201,
/// SET_VELOCITY_LIMIT, ...) override the settings. Accelerations that the layers set themselves
/// stay as in the settings. Lines with templates are ignored.
MachineLimits LimitsAfterStart(const MotionOptions& options);

}  // namespace slicefarm::motion
