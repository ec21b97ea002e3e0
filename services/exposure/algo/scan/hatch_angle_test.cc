#include "services/exposure/algo/scan/hatch_angle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::hatch_angle_test {
namespace {

/// Returns the angle between a direction and the gas flow or its opposite, in [0, 90].
double BesideGas(double deg, double gas_deg) {
  const double beside = std::fmod(std::fmod(deg - gas_deg, 180) + 180, 180);
  return std::min(beside, 180 - beside);
}

ExposureOptions With(ScanStrategy strategy, double gas_deg, double window_deg) {
  ExposureOptions options;
  options.strategy = strategy;
  options.gas_flow_deg = gas_deg;
  options.gas_window_deg = window_deg;
  return options;
}

TEST(HatchAngle, TurnsByLayer) {
  const ExposureOptions options;
  EXPECT_DOUBLE_EQ(HatchAngle(options, 0), 45);
  EXPECT_DOUBLE_EQ(HatchAngle(options, 1), 112);
  EXPECT_DOUBLE_EQ(HatchAngle(options, 5), 20);
}

/// Returns the directions of a layer's lines. Islands have two.
std::vector<double> Directions(const ExposureOptions& options, int32_t layer) {
  const double angle = HatchAngle(options, layer);
  if (options.strategy == ScanStrategy::kIslands) return {angle, angle + 90};
  return {angle};
}

double LeastBeside(const ExposureOptions& options, int32_t layer, double gas_deg) {
  double least = 90;
  for (const double deg : Directions(options, layer))
    least = std::min(least, BesideGas(deg, gas_deg));
  return least;
}

TEST(HatchAngle, KeepsFromTheFlow) {
  for (const ScanStrategy strategy :
       {ScanStrategy::kHatch, ScanStrategy::kStripes, ScanStrategy::kIslands}) {
    const double widest = strategy == ScanStrategy::kIslands ? 22.5 : 45;
    for (const double gas : {-170.0, 0.0, 33.0, 90.0, 359.0})
      for (const double window : {1.0, 15.0, widest}) {
        const ExposureOptions free = With(strategy, gas, 0), options = With(strategy, gas, window);
        for (int32_t layer = 0; layer < 500; ++layer) {
          EXPECT_GE(LeastBeside(options, layer, gas), window - 1e-9);
          if (LeastBeside(free, layer, gas) < window + 1e-9) continue;
          EXPECT_DOUBLE_EQ(HatchAngle(options, layer), HatchAngle(free, layer));
        }
      }
  }
}

TEST(HatchAngle, LinesOfOneWayRunAgainstTheFlow) {
  for (const ScanStrategy strategy : {ScanStrategy::kHatch, ScanStrategy::kIslands}) {
    const double period = strategy == ScanStrategy::kIslands ? 90 : 180;
    const ExposureOptions free = With(strategy, 70, 10);
    ExposureOptions options = free;
    options.alternate_directions = false;
    options.jump_order = JumpOrder::kAgainstGas;
    for (int32_t layer = 0; layer < 200; ++layer) {
      for (const double deg : Directions(options, layer))
        EXPECT_LE(std::cos((deg - 70) * M_PI / 180), 1e-9);
      // The lines are the same, ignoring direction.
      const double off =
          std::fmod(std::abs(HatchAngle(options, layer) - HatchAngle(free, layer)), period);
      EXPECT_LT(std::min(off, period - off), 1e-9);
    }
  }
}

}  // namespace
}  // namespace slicefarm::exposure::hatch_angle_test
