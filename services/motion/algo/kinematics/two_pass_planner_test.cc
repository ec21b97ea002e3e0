#include "services/motion/algo/kinematics/two_pass_planner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::motion {
namespace {

/// Junctions at a fixed speed.
class Fixed : public TwoPassPlanner {
 public:
  explicit Fixed(double junction_v2) : TwoPassPlanner({}), junction_v2_(junction_v2) {}
  KinematicMove Limited(const KinematicMove& move) const override { return move; }

 protected:
  double StartV2(const KinematicMove& /*first*/) const override { return 0; }
  double JunctionV2(const KinematicMove& /*before*/, const KinematicMove& /*move*/) const override {
    return junction_v2_;
  }
  double RestV2() const override { return 0; }

 private:
  double junction_v2_;
};

TEST(TwoPassPlanner, BothPassesLowerJunctions) {
  Fixed planner(1e4);
  // Reach 2 a L: 200, 2000, 100.
  planner.Add({0.1, {1, 0, 0, 0}, 100, 1000});
  planner.Add({1, {1, 0, 0, 0}, 100, 1000});
  planner.Add({0.05, {1, 0, 0, 0}, 100, 1000});
  const auto profiles = planner.Stop();
  EXPECT_NEAR(profiles[0].exit_mm_s, std::sqrt(200), 1e-9) << "forward";
  EXPECT_NEAR(profiles[1].exit_mm_s, std::sqrt(100), 1e-9) << "backward";
  EXPECT_NEAR(profiles[1].cruise_mm_s, std::sqrt((200 + 100 + 2000) / 2.0), 1e-9);
}

}  // namespace
}  // namespace slicefarm::motion
