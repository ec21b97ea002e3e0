#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "common/gcode/gcode_text.h"
#include "common/model/options/machine_limits.h"
#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm::motion {

/// Writes one command with the parameters that are set (above 0); nothing if none is.
class LimitCommand {
 public:
  LimitCommand(std::string_view name, GcodeText& out) : name_(name), out_(out) {}
  ~LimitCommand() {
    if (begun_) out_ << '\n';
  }
  LimitCommand(const LimitCommand&) = delete;
  LimitCommand& operator=(const LimitCommand&) = delete;

  LimitCommand& Set(std::string_view parameter, double value);
  /// The same for a limit that may be 0.
  LimitCommand& SetEven0(std::string_view parameter, double value);
  /// X, Y, Z and E.
  LimitCommand& SetAxes(std::span<const double, 4> values, double factor = 1);

 private:
  std::string_view name_;
  GcodeText& out_;
  bool begun_ = false;
};

/// Takes over X, Y, Z and E of a command, in `unit`.
void ReadAxes(const GcodeLine& line, double unit, std::array<double, 4>& values);

/// Takes over a word or a parameter that is there and above 0.
void ReadLimit(std::optional<double> given, double& value);

/// M204 of Marlin and RepRapFirmware: accelerations of printing (P), travel (T), both (S), filament
/// (R).
void ReadM204(const GcodeLine& line, MachineLimits& limits);

/// `M204 P1000 T2000`, of printing and of travels; one of them 0: not told.
void WriteM204(double print_mm_s2, double travel_mm_s2, GcodeText& out);

/// `M204 S1000`, of all moves.
void WriteM204(double all_mm_s2, GcodeText& out);

/// What stands where settings say nothing, in mm/s^2.
inline constexpr double kDefaultAccelerationMmS2 = 1000;

inline double AccelerationOr(double value, double otherwise) {
  if (value > 0) return value;
  return otherwise > 0 ? otherwise : kDefaultAccelerationMmS2;
}

}  // namespace slicefarm::motion
