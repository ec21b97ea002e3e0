#include "common/gcode/dialect.h"

#include <cmath>
#include <cstdlib>

namespace slicefarm::gcode {
namespace {

constexpr Dialect kMarlin{.name = "Marlin",
                          .has_feed_modes = false,
                          .has_program_end = false,
                          .inline_power = true,
                          .dwells_in_ms = true};
constexpr Dialect kGrbl{.name = "grbl"};
constexpr Dialect kLinuxCnc{.name = "LinuxCNC", .has_tool_table = true, .has_blending = true};

}  // namespace

const Dialect& DialectOf(Controller controller) {
  switch (controller) {
    case Controller::kMarlin:
      return kMarlin;
    case Controller::kGrbl:
      return kGrbl;
    case Controller::kLinuxCnc:
      return kLinuxCnc;
  }
  std::abort();  // unreachable: all values of Controller are handled
}

void WriteUnits(const Dialect& dialect, GcodeText& out) {
  out << "G21\nG90\n";
  if (dialect.has_feed_modes) out << "G94\n";
}

void WriteDwell(const Dialect& dialect, double us, GcodeText& out) {
  out << "G4 P";
  if (dialect.dwells_in_ms)
    out.Integer(static_cast<int64_t>(std::ceil(us / 1000)));
  else
    out.Decimal(std::llround(us), 6);
  out << '\n';
}

void WriteProgramEnd(const Dialect& dialect, GcodeText& out) {
  if (dialect.has_program_end) out << "M2\n";
}

}  // namespace slicefarm::gcode
