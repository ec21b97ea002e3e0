#include "services/coordinator/algo/pipeline/cost.h"

#include <gtest/gtest.h>

namespace slicefarm::coordinator::cost_test {
namespace {

TEST(CostOf, AddsUpWhatTheFarmCharges) {
  const Rates rates = {.currency = "CHF",
                       .setup = 1.5,
                       .machine_per_hour = 2,
                       .energy_per_kwh = 0.3,
                       .printer_power_w = 200,
                       .filament_per_kg = 25};
  const Cost cost = CostOf(rates, 5400, 40, 0);
  EXPECT_EQ(cost.currency, "CHF");
  EXPECT_DOUBLE_EQ(cost.setup, 1.5);
  EXPECT_DOUBLE_EQ(cost.machine, 3);
  EXPECT_DOUBLE_EQ(cost.energy, 0.09);
  EXPECT_DOUBLE_EQ(cost.filament, 1);
  EXPECT_DOUBLE_EQ(cost.Total(), 5.59);
}

TEST(CostOf, AFilamentWithAPriceOfItsOwnHasThat) {
  EXPECT_DOUBLE_EQ(CostOf({.filament_per_kg = 25}, 0, 500, 60).filament, 30);
}

TEST(CostOf, WithoutRatesNothingCosts) { EXPECT_EQ(CostOf({}, 1e6, 1e6, 0).Total(), 0); }

}  // namespace
}  // namespace slicefarm::coordinator::cost_test
