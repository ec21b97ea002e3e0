#pragma once

#include <cstdint>

#include "common/gcode/gcode_text.h"

namespace slicefarm::motion {

/// Writes `M106 S89`, or `M107` for 0.
void WriteFan(int32_t percent, GcodeText& out);

/// Properties of the part cooling fan.
struct FanLimits {
  int32_t least_percent = 0;  ///< least speed of a fan that runs
  double kickstart_s = 0;     ///< time at full speed before a rise by 100 %

  /// Returns the speed that is set for `percent`.
  int32_t Raised(int32_t percent) const {
    return percent > 0 && percent < least_percent ? least_percent : percent;
  }
};

/// Sets the fan's speed. Before a rise by more than 10 %, the fan runs at full speed for a time
/// that is proportional to the rise (FanLimits::kickstart_s). The full speed ends with the move in
/// which this time is over.
class FanCommand {
 public:
  /// `percent`: speed before the first command; negative: unknown.
  FanCommand(const FanLimits& limits, int32_t percent) : limits_(limits), percent_(percent) {}

  /// Returns the speed that is set, in percent.
  int32_t percent() const { return percent_; }

  /// Writes the command for a speed, if it differs from the last one. `percent`: already raised.
  void Set(int32_t percent, GcodeText& out);
  /// Returns true while the fan runs at full speed before a lower speed.
  bool IsKicking() const { return kick_s_ > 0; }
  /// Counts the time of a written move. Writes the set speed when the time at full speed is over.
  void Pass(double time_s, GcodeText& out);
  /// Ends the time at full speed, and writes the set speed.
  void Finish(GcodeText& out);

 private:
  FanLimits limits_;
  int32_t percent_;
  double kick_s_ = 0;  ///< time left at full speed
};

}  // namespace slicefarm::motion
