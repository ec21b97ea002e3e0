#include "services/motion/algo/program/custom_use.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/portable_math.h"
#include "common/base/text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/program/gcode_machine.h"
#include "services/motion/algo/program/program_time.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// Returns a line that sets the position to the target of the first move in the plane, if it is a
/// travel.
std::string StartLine(std::string_view code, GcodeMachine machine) {
  for (const std::string_view line : Split(code, "\n"))
    for (const ProgramMove& move : machine.Read(ParseGcodeLine(line)).moves)
      if (move.InPlane())
        return move.Prints() ? "" : absl::StrCat("G92 X", move.to[kX], " Y", move.to[kY], "\n");
  return "";
}

}  // namespace

FeatureUse UseOfCode(std::string_view code, const MotionOptions& options) {
  const Firmware& firmware = FirmwareOf(options.flavor);
  const MachineSetup setup = SetupOf(options);
  const std::string whole =
      absl::StrCat(options.writing.relative_e ? "M83\n" : "M82\n",
                   StartLine(code, GcodeMachine(firmware, setup)), std::string(code));
  FeatureUse use;
  use.time_s = TimeOfProgram(whole, firmware, setup).TotalS();
  GcodeMachine machine(firmware, setup);
  for (const std::string_view line : Split(whole, "\n"))
    for (const ProgramMove& move : machine.Read(ParseGcodeLine(line)).moves) {
      if (!move.Prints()) continue;
      use.length_mm += Hypot(move.to[kX] - move.from[kX], move.to[kY] - move.from[kY]);
      use.filament_mm += move.Filament();
    }
  use.volume_mm3 = use.filament_mm * FilamentAreaMm2(options);
  return use;
}

}  // namespace slicefarm::motion
