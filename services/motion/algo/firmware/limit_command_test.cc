#include "services/motion/algo/firmware/limit_command.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::limit_command_test {
namespace {

TEST(LimitCommand, WritesWhatIsSet) {
  GcodeText out;
  LimitCommand("M201", out).SetAxes(std::array{3000.0, 0.0, 500.0, 0.5});
  LimitCommand("M566", out).SetAxes(std::array{1.0, 2.0, 0.0, 0.0}, 60);
  LimitCommand("M205", out).Set("J", 0);
  LimitCommand("M205", out).SetEven0("S", 0);
  EXPECT_EQ(out.text(), "M201 X3000 Z500 E0.5\nM566 X60 Y120\nM205 S0\n");
}

TEST(ReadAxes, TakesOverWhatIsThere) {
  std::array<double, 4> values = {1, 2, 3, 4};
  ReadAxes(ParseGcodeLine("M203 X6000 E300"), 1.0 / 60, values);
  EXPECT_EQ(values, (std::array{100.0, 2.0, 3.0, 5.0}));
}

TEST(ReadLimit, NothingBelowZero) {
  double value = 7;
  ReadLimit(std::nullopt, value);
  ReadLimit(0.0, value);
  EXPECT_EQ(value, 7);
  ReadLimit(2.0, value);
  EXPECT_EQ(value, 2);
}

TEST(AccelerationOr, FallsBack) {
  EXPECT_EQ(AccelerationOr(5, 6), 5);
  EXPECT_EQ(AccelerationOr(0, 6), 6);
  EXPECT_EQ(AccelerationOr(0, 0), kDefaultAccelerationMmS2);
}

}  // namespace
}  // namespace slicefarm::motion::limit_command_test
