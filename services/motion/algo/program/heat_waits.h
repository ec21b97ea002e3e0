#pragma once

#include <optional>

#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm::motion {

/// How fast a printer heats up, in C/s; 0: not known.
struct HeatingRates {
  double nozzle_c_s = 0;
  double bed_c_s = 0;
};

/// Follows what a program asks of nozzle and bed (M104, M109, M140, M190): both begin at 25 C, heat
/// up at their rates from when they are told to, and cool down at once.
class HeatWaits {
 public:
  explicit HeatWaits(const HeatingRates& rates) : nozzle_{rates.nozzle_c_s}, bed_{rates.bed_c_s} {}

  /// Whether a line waits for heat.
  static bool Waits(const GcodeLine& line);

  /// `now_s`: when the line is run. How long it waits, in s; 0 if it does not, nothing if it waits
  /// for something whose rate is not known.
  std::optional<double> Read(const GcodeLine& line, double now_s);

 private:
  struct Heater {
    double rate_c_s = 0;
    double from_c = 25;
    double to_c = 25;
    double since_s = 0;

    void Set(double celsius, double now_s);
    double WaitS(double now_s) const;
  };

  Heater nozzle_;
  Heater bed_;
};

}  // namespace slicefarm::motion
