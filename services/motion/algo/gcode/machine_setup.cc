#include "services/motion/algo/gcode/machine_setup.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

namespace slicefarm::motion {
namespace {

/// One command with the parameters that are set; nothing if none is.
class Command {
 public:
  Command(std::string_view name, GcodeText& out) : name_(name), out_(out) {}
  ~Command() {
    if (begun_) out_ << '\n';
  }
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  Command& Set(std::string_view parameter, double value) {
    if (value <= 0) return *this;
    if (!begun_) out_ << name_;
    begun_ = true;
    out_ << ' ' << parameter;
    out_.Real(value, 3);
    return *this;
  }
  Command& SetAxes(std::span<const double> values) {
    constexpr std::string_view kAxes[] = {"X", "Y", "Z", "E"};
    for (size_t i = 0; i < values.size(); ++i) Set(kAxes[i], values[i]);
    return *this;
  }

 private:
  std::string_view name_;
  GcodeText& out_;
  bool begun_ = false;
};

void WriteMarlinLimits(const MotionOptions& options, GcodeText& out) {
  const MachineLimits& limits = options.limits;
  Command("M201", out).SetAxes(limits.max_acceleration_mm_s2);
  Command("M203", out).SetAxes(limits.max_feedrate_mm_s);
  if (options.flavor == GcodeFlavor::kMarlin2) {
    Command("M204", out)
        .Set("P", limits.max_acceleration_extruding_mm_s2)
        .Set("R", limits.max_acceleration_retracting_mm_s2)
        .Set("T", limits.max_acceleration_travel_mm_s2);
  } else {
    Command("M204", out)
        .Set("S", limits.max_acceleration_extruding_mm_s2)
        .Set("R", limits.max_acceleration_retracting_mm_s2);
  }
  if (limits.junction_deviation_mm > 0) {
    Command("M205", out).Set("J", limits.junction_deviation_mm);
  } else {
    Command("M205", out).SetAxes(limits.max_jerk_mm_s);
  }
}

}  // namespace

void WriteMachineLimits(const MotionOptions& options, GcodeText& out) {
  const MachineLimits& limits = options.limits;
  if (!limits.emit_to_gcode) return;
  if (options.flavor != GcodeFlavor::kKlipper) {
    WriteMarlinLimits(options, out);
    return;
  }
  Command("SET_VELOCITY_LIMIT", out)
      .Set("VELOCITY=", std::min(limits.max_feedrate_mm_s[0], limits.max_feedrate_mm_s[1]))
      .Set("ACCEL=", limits.max_acceleration_extruding_mm_s2)
      .Set("SQUARE_CORNER_VELOCITY=", limits.square_corner_velocity_mm_s);
}

void WriteTemperature(std::string_view command, int32_t celsius, GcodeText& out) {
  if (celsius <= 0) return;
  out << command << " S";
  out.Integer(celsius) << '\n';
}

void WriteStart(const MotionOptions& options, std::string_view start_gcode, GcodeText& out) {
  const bool sets_bed = Commands(start_gcode, {"M140", "M190"});
  const bool sets_nozzle = Commands(start_gcode, {"M104", "M109"});
  if (!sets_bed) WriteTemperature("M190", options.first_layer_bed_temperature_c, out);
  if (!sets_nozzle) WriteTemperature("M104", options.first_layer_temperature_c, out);
  out.Lines(start_gcode);
  if (!sets_nozzle) WriteTemperature("M109", options.first_layer_temperature_c, out);
}

bool Commands(std::string_view gcode, std::initializer_list<std::string_view> commands) {
  while (!gcode.empty()) {
    const size_t end = std::min(gcode.find('\n'), gcode.size());
    std::string_view line = gcode.substr(0, end);
    gcode.remove_prefix(std::min(end + 1, gcode.size()));
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    for (const std::string_view command : commands) {
      if (!line.starts_with(command)) continue;
      const bool whole = line.size() == command.size() ||
                         std::isdigit(static_cast<unsigned char>(line[command.size()])) == 0;
      if (whole) return true;
    }
  }
  return false;
}

}  // namespace slicefarm::motion
