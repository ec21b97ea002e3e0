#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "common/gcode/gcode_text.h"
#include "common/model/options/machine_limits.h"
#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm::motion {

/// Writes one command with the parameters above 0. Writes nothing if there are none.
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
  /// Adds a parameter that may be 0.
  LimitCommand& SetEven0(std::string_view parameter, double value);
  /// Adds X, Y, Z and E.
  LimitCommand& SetAxes(std::span<const double, 4> values, double factor = 1);

 private:
  std::string_view name_;
  GcodeText& out_;
  bool begun_ = false;
};

/// Reads X, Y, Z and E of a command into `values`, converted from `unit`.
void ReadAxes(const GcodeLine& line, double unit, std::array<double, 4>& values);

/// Reads a word or a parameter into `value` if it is present and above 0.
void ReadLimit(std::optional<double> given, double& value);

/// Reads M204 of Marlin and RepRapFirmware: accelerations of printing (P), travel (T), both (S),
/// filament (R).
void ReadM204(const GcodeLine& line, MachineLimits& limits);

/// Writes `M204 P1000 T2000`, for printing and for travels. A value of 0 is left out.
void WriteM204(double print_mm_s2, double travel_mm_s2, GcodeText& out);

/// Writes `M204 S1000`, for all moves.
void WriteM204(double all_mm_s2, GcodeText& out);

/// Acceleration without any setting, in mm/s^2.
inline constexpr double kDefaultAccelerationMmS2 = 1000;

/// Returns the first of `value`, `otherwise` and the default that is above 0.
inline double AccelerationOr(double value, double otherwise) {
  if (value > 0) return value;
  return otherwise > 0 ? otherwise : kDefaultAccelerationMmS2;
}

}  // namespace slicefarm::motion
