#pragma once

#include <string_view>

#include "common/model/options/machine_limits.h"
#include "common/gcode/gcode_text.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Writes the machine's limits, if the settings ask for it (machine_limits_usage = emit_to_gcode):
/// M201, M203, M204 and M205 for Marlin, SET_VELOCITY_LIMIT for Klipper. Limits of 0 are left as
/// they are.
void WriteMachineLimits(const MotionOptions& options, GcodeText& out);

/// `M104 S210`; nothing for 0, which leaves the temperature as it is.
void WriteTemperature(std::string_view command, int32_t celsius, GcodeText& out);

/// G-code before the layers, filled in.
struct StartCode {
  std::string_view machine;   ///< start_gcode
  std::string_view filament;  ///< start_filament_gcode
};

/// Writes the machine's start G-code and heats up around it: the bed before, the nozzle and the
/// chamber begun before and waited for after; but leaves to it what it does by itself, or all of it
/// (emit_temperatures). Then it chooses the tool, if there are several, and writes the filament's:
/// temperatures there come on top of those that were waited for.
/// Source: PrusaSlicer.
void WriteStart(const MotionOptions& options, const StartCode& code, GcodeText& out);

/// The limits that the layers run with: what start G-code says (M201, SET_VELOCITY_LIMIT, ...)
/// holds over the settings. Accelerations that the layers tell by themselves stay the settings'.
/// Lines with templates are not looked at.
MachineLimits LimitsAfterStart(const MotionOptions& options);

}  // namespace slicefarm::motion
