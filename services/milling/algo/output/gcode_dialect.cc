#include "services/milling/algo/output/gcode_dialect.h"

#include <fmt/core.h>

#include <string_view>

namespace slicefarm::milling {
namespace {

/// The spindle gets this long to come up to its speed.
constexpr int kSpindleSeconds = 3;

std::string_view CoolantWord(Coolant coolant) {
  switch (coolant) {
    case Coolant::kOff:
      return "";
    case Coolant::kMist:
      return "M7\n";
    case Coolant::kFlood:
      return "M8\n";
  }
  return "";
}

std::string SpindleStart(const MachiningOptions& machining) {
  return fmt::format("S{} M3\nG4 P{}\n{}", machining.spindle_rpm, kSpindleSeconds,
                     CoolantWord(machining.coolant));
}

/// LinuxCNC 2.9: "G-Codes", "M-Codes" of its manual.
class LinuxCncDialect : public GcodeDialect {
 public:
  std::string Start(const MachiningOptions& machining, double tolerance_mm,
                    double safe_z_mm) const override {
    // G64 P: blending stays within the tolerance. G43: the length of the tool table.
    return fmt::format(
        "G21 G17 G90 G91.1 G94 G40 G49 G80\nG64 P{:.3f}\nT{} M6\nG43 H{}\nG0 Z{:.3f}\n{}",
        tolerance_mm, machining.tool_number, machining.tool_number, safe_z_mm,
        SpindleStart(machining));
  }
  std::string End() const override { return "M9\nM5\nG49\nM2\n"; }
};

/// grbl 1.1: no change of tools and no table of their lengths, so Z is set for the tool by hand.
class GrblDialect : public GcodeDialect {
 public:
  std::string Start(const MachiningOptions& machining, double /*tolerance_mm*/,
                    double safe_z_mm) const override {
    return fmt::format("G21 G17 G90 G91.1 G94 G40 G49\nT{}\nG0 Z{:.3f}\n{}", machining.tool_number,
                       safe_z_mm, SpindleStart(machining));
  }
  std::string End() const override { return "M9\nM5\nM2\n"; }
};

}  // namespace

std::unique_ptr<GcodeDialect> DialectOf(MillDialect dialect) {
  switch (dialect) {
    case MillDialect::kLinuxCnc:
      return std::make_unique<LinuxCncDialect>();
    case MillDialect::kGrbl:
      return std::make_unique<GrblDialect>();
  }
  return nullptr;
}

}  // namespace slicefarm::milling
