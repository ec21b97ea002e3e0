#include "services/exposure/algo/scan/hatch_angle.h"

#include <algorithm>
#include <cmath>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {
namespace {

/// Returns the angle reduced to [0, period).
double Remainder(double deg, double period) { return deg - period * std::floor(deg / period); }

/// Returns the period of the hatch in degrees: rotated by it, the lines have the same angles again.
double PeriodOf(const ExposureOptions& options) {
  return options.strategy == ScanStrategy::kIslands ? 90 : 180;
}

}  // namespace

double HatchAngle(const ExposureOptions& options, int32_t layer) {
  double angle = options.hatch_angle_deg + options.layer_rotation_deg * layer;
  const double period = PeriodOf(options);
  double beside = Remainder(angle - options.gas_flow_deg, period);
  if (std::min(beside, period - beside) < options.gas_window_deg) {
    angle += period / 2;
    beside = Remainder(beside + period / 2, period);
  }
  // Lines at 90 to 270 degrees to the flow are directed against it. All other lines are reversed.
  if (options.jump_order == JumpOrder::kAgainstGas && !options.alternate_directions)
    angle = options.gas_flow_deg + (beside < 90 ? beside + period : beside);
  return Remainder(angle, 360);
}

}  // namespace slicefarm::exposure
