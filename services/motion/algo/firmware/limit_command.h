#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "common/gcode/gcode_text.h"
#include "common/model/options/machine_limits.h"
#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm::motion {

/// Builder for one command line. Parameters with a value above 0 are appended; without any
/// parameter, no line is written.
class LimitCommand {
 public:
  LimitCommand(std::string_view name, GcodeText& out) : name_(name), out_(out) {}
  ~LimitCommand() {
    if (begun_) out_ << '\n';
  }
  LimitCommand(const LimitCommand&) = delete;
  LimitCommand& operator=(const LimitCommand&) = delete;

  /// Adds a parameter if its value is above 0.
  LimitCommand& Set(std::string_view parameter, double value);
  /// Adds a parameter, even if its value is 0.
  LimitCommand& SetEven0(std::string_view parameter, double value);
  /// Adds the parameters X, Y, Z and E with `values` times `factor`, each if it is above 0.
  LimitCommand& SetAxes(std::span<const double, 4> values, double factor = 1);

 private:
  std::string_view name_;
  GcodeText& out_;
  bool begun_ = false;
};

/// Reads the words X, Y, Z and E that the command has into `values`, multiplied by `unit`.
void ReadAxes(const GcodeLine& line, double unit, std::array<double, 4>& values);

/// Writes `given` to `value` if it exists and is above 0.
void ReadLimit(std::optional<double> given, double& value);

/// Reads M204 of Marlin and RepRapFirmware into `limits`. Words: P (printing), T (travel), S
/// (both), R (retraction).
void ReadM204(const GcodeLine& line, MachineLimits& limits);

/// Writes `M204 P1000 T2000`, for printing and for travels. A value of 0 is left out.
void WriteM204(double print_mm_s2, double travel_mm_s2, GcodeText& out);

/// Writes `M204 S1000`, for all moves.
void WriteM204(double all_mm_s2, GcodeText& out);

/// Acceleration in mm/s^2 if neither settings nor machine limits give one.
inline constexpr double kDefaultAccelerationMmS2 = 1000;

/// Returns `value` if it is above 0, else `otherwise` if it is above 0, else
/// kDefaultAccelerationMmS2.
inline double AccelerationOr(double value, double otherwise) {
  if (value > 0) return value;
  return otherwise > 0 ? otherwise : kDefaultAccelerationMmS2;
}

}  // namespace slicefarm::motion
