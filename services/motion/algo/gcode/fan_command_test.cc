#include "services/motion/algo/gcode/fan_command.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::fan_command_test {
namespace {

TEST(WriteFan, InTheUnitsOfM106) {
  GcodeText out;
  WriteFan(0, out);
  WriteFan(35, out);
  WriteFan(100, out);
  EXPECT_EQ(out.text(), "M107\nM106 S89\nM106 S255\n");
}

TEST(FanLimits, RaiseARunningFan) {
  const FanLimits limits{.least_percent = 40};
  EXPECT_EQ(limits.Raised(0), 0);
  EXPECT_EQ(limits.Raised(1), 40);
  EXPECT_EQ(limits.Raised(70), 70);
}

/// Returns the commands for a fan that is set to `percent`, then runs for moves of 0.1 s.
std::string Commands(FanLimits limits, int32_t before, int32_t percent, int moves) {
  FanCommand fan(limits, before);
  GcodeText out;
  fan.Set(percent, out);
  for (int i = 0; i < moves; ++i) {
    out << "G1\n";
    fan.Pass(0.1, out);
  }
  return out.Take();
}

TEST(FanCommand, StartsAtFullSpeedForItsShareOfTheTime) {
  const FanLimits kick{.kickstart_s = 0.5};
  // A rise by 50 % takes 0.25 s: the full speed ends with the third move.
  EXPECT_EQ(Commands(kick, 0, 50, 4), "M106 S255\nG1\nG1\nG1\nM106 S127\nG1\n");
  EXPECT_EQ(Commands(kick, 0, 10, 1), "M106 S26\nG1\n") << "a small rise needs none";
  EXPECT_EQ(Commands(kick, 50, 20, 1), "M106 S51\nG1\n");
  EXPECT_EQ(Commands(kick, 0, 100, 1), "M106 S255\nG1\n");
  EXPECT_EQ(Commands(kick, -1, 50, 1), "M106 S127\nG1\n") << "the speed before is unknown";
  EXPECT_EQ(Commands({}, 0, 50, 1), "M106 S127\nG1\n");
}

TEST(FanCommand, ASecondRiseAddsItsTime) {
  FanCommand fan({.kickstart_s = 1}, 0);
  GcodeText out;
  fan.Set(20, out);
  fan.Set(40, out);
  fan.Pass(0.3, out);
  EXPECT_EQ(out.text(), "M106 S255\n");
  fan.Pass(0.2, out);
  EXPECT_EQ(out.text(), "M106 S255\nM106 S102\n");
}

TEST(FanCommand, ASlowerSpeedEndsTheFullSpeed) {
  FanCommand fan({.kickstart_s = 1}, 0);
  GcodeText out;
  fan.Set(60, out);
  fan.Set(0, out);
  fan.Finish(out);
  EXPECT_EQ(out.text(), "M106 S255\nM107\n");
}

}  // namespace
}  // namespace slicefarm::motion::fan_command_test
