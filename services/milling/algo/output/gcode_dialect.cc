#include "services/milling/algo/output/gcode_dialect.h"

#include <fmt/core.h>

#include <string_view>

#include "common/gcode/dialect.h"
#include "common/gcode/gcode_text.h"

namespace slicefarm::milling {
namespace {

/// Time for the spindle to reach its speed.
constexpr double kSpindleUs = 3e6;

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

std::string SpindleStart(const gcode::Dialect& dialect, const MachiningOptions& machining) {
  GcodeText out;
  out << fmt::format("S{} M3\n", machining.spindle_rpm);
  gcode::WriteDwell(dialect, kSpindleUs, out);
  out << CoolantWord(machining.coolant);
  return out.Take();
}

class TableDialect : public GcodeDialect {
 public:
  explicit TableDialect(gcode::Controller controller) : dialect_(gcode::DialectOf(controller)) {}

  std::string Start(const MachiningOptions& machining, double tolerance_mm,
                    double safe_z_mm) const override {
    std::string text = "G21 G17 G90 G91.1 G94 G40 G49";
    if (dialect_.has_blending) text += fmt::format(" G80\nG64 P{:.3f}", tolerance_mm);
    text += fmt::format("\nT{}", machining.tool_number);
    // If the controller has no table of tool lengths, the user sets Z for the tool manually.
    if (dialect_.has_tool_table) text += fmt::format(" M6\nG43 H{}", machining.tool_number);
    return text + fmt::format("\nG0 Z{:.3f}\n", safe_z_mm) + SpindleStart(dialect_, machining);
  }
  std::string End() const override {
    GcodeText out;
    out << "M9\nM5\n" << (dialect_.has_tool_table ? "G49\n" : "");
    gcode::WriteProgramEnd(dialect_, out);
    return out.Take();
  }

 private:
  const gcode::Dialect& dialect_;
};

}  // namespace

std::unique_ptr<GcodeDialect> DialectOf(MillDialect dialect) {
  switch (dialect) {
    case MillDialect::kLinuxCnc:
      return std::make_unique<TableDialect>(gcode::Controller::kLinuxCnc);
    case MillDialect::kGrbl:
      return std::make_unique<TableDialect>(gcode::Controller::kGrbl);
  }
  return nullptr;
}

}  // namespace slicefarm::milling
