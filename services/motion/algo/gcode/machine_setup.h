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

/// Writes `M104 S210`, or nothing for 0, which leaves the temperature unchanged.
void WriteTemperature(std::string_view command, int32_t celsius, GcodeText& out);

/// G-code before the layers, with filled-in templates.
struct StartCode {
  std::string_view machine;   ///< `start_gcode`
  std::string_view filament;  ///< `start_filament_gcode`
};

/// Writes the machine's start G-code, with heating commands before and after it. The bed is heated
/// before the start G-code. Nozzle and chamber start heating before it and are waited for after it.
/// Heating commands that the start G-code has itself are left out. Without emit_temperatures all of
/// them are left out. Then the tool is selected, if there are several, and the filament's start
/// G-code is written. Temperatures in this G-code take effect after the waits. Source: PrusaSlicer.
void WriteStart(const MotionOptions& options, const StartCode& code, GcodeText& out);

/// Returns the limits of the layers: limits in the start G-code (M201, SET_VELOCITY_LIMIT, ...)
/// override the settings. Accelerations that the layers set themselves stay as in the settings.
/// Lines with templates are ignored.
MachineLimits LimitsAfterStart(const MotionOptions& options);

}  // namespace slicefarm::motion
