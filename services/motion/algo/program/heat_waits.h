#pragma once

#include <optional>

#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm::motion {

/// Heating rates of a printer, in C/s; 0: not known.
struct HeatingRates {
  double nozzle_c_s = 0;
  double bed_c_s = 0;
};

/// Tracks the temperatures that a program sets for nozzle and bed (M104, M109, M140, M190). Both
/// heaters begin at 25 C. From the time of the command, a heater warms up at its rate. Cooling
/// takes no time.
class HeatWaits {
 public:
  explicit HeatWaits(const HeatingRates& rates) : nozzle_{rates.nozzle_c_s}, bed_{rates.bed_c_s} {}

  /// Returns true if the line is a command that waits until a heater is hot.
  static bool Waits(const GcodeLine& line);

  /// Runs a line and returns the time that it waits, in s. The result is 0 for a line that does not
  /// wait, and nullopt if the heating rate is not known. `now_s`: time when the line is run.
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
