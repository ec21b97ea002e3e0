#include "services/planning/algo/supports/generator/overhangs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/base/portable_math.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::overhangs_test {
namespace {

/// Returns a box of 10 x 10 mm under one that extends `by_mm` farther to the right.
TestStack Step(double by_mm) {
  return TestStack(4, [by_mm](double z) { return BoxOf(0, 0, z < 0.4 ? 10 : 10 + by_mm, 10); });
}

TEST(OverhangThreshold, AngleOrHalfAWall) {
  SupportOptions options;
  EXPECT_EQ(OverhangThreshold(options, 200'000, 200'000), 225'000);
  options.style = SupportStyle::kTree;
  EXPECT_EQ(OverhangThreshold(options, 200'000, 200'000), 300'000);
  options.threshold_rad = std::numbers::pi / 4;
  EXPECT_EQ(OverhangThreshold(options, 200'000, 200'000), 193'138) << "45 degrees are supported";
  EXPECT_EQ(OverhangThreshold(options, 100'000, 300'000), 193'138);
}

TEST(OverhangOf, BeyondTheThresholdOnly) {
  EXPECT_TRUE(OverhangOf(Step(0.2).Problem(), 2, {}).steep.empty());
  const TestStack step = Step(2);
  const Overhang overhang = OverhangOf(step.Problem(), 2, {});
  EXPECT_NEAR(AreaMm2(overhang.steep), (2 - 0.225) * 10, 0.01);
  EXPECT_NEAR(AreaMm2(overhang.contact), 20, 0.01);
  EXPECT_TRUE(OverhangOf(step.Problem(), 1, {}).steep.empty());
  EXPECT_TRUE(OverhangOf(step.Problem(), 3, {}).steep.empty());
  EXPECT_TRUE(OverhangOf(step.Problem(), 0, {}).steep.empty());
}

TEST(OverhangOf, EnforcersAndBlockers) {
  const TestStack step = Step(0.2);
  const MultiPolygon half = BoxOf(9, 0, 11, 5);
  SupportProblem problem = step.Problem();
  problem.part[2].enforcers = &half;
  EXPECT_NEAR(AreaMm2(OverhangOf(problem, 2, {}).steep), 0.15 * 5, 0.01);
  const TestStack wide = Step(2);
  problem = wide.Problem();
  problem.part[2].blockers = &half;
  const MultiPolygon left = Intersection(OverhangOf(problem, 2, {}).contact, half);
  EXPECT_TRUE(left.empty());
  SupportOptions by_hand;
  by_hand.automatic = false;
  EXPECT_TRUE(OverhangOf(wide.Problem(), 2, by_hand).steep.empty());
  by_hand.enforced_layers = 3;
  EXPECT_NEAR(AreaMm2(OverhangOf(wide.Problem(), 2, by_hand).steep), 19.5, 0.01);
  EXPECT_TRUE(OverhangOf(wide.Problem(), 3, by_hand).steep.empty());
}

TEST(OverhangOf, BridgesAreLeftOutIfAsked) {
  const TestStack gate(3, [](double z) {
    return z < 0.4 ? Union(BoxOf(0, 0, 2, 10), BoxOf(12, 0, 14, 10)) : BoxOf(0, 0, 14, 10);
  });
  EXPECT_TRUE(OverhangOf(gate.Problem(), 2, {}).steep.empty());
  SupportOptions all;
  all.skip_bridges = false;
  EXPECT_NEAR(AreaMm2(OverhangOf(gate.Problem(), 2, all).steep), (10 - 0.45) * 10, 0.02);
}

TEST(IslandsInAirOf, TouchNothingBelow) {
  const TestStack pair(3, [](double z) {
    return z < 0.4 ? BoxOf(0, 0, 5, 5) : Union(BoxOf(0, 0, 5, 5), BoxOf(7, 0, 7.1, 0.1));
  });
  EXPECT_EQ(IslandsInAirOf(pair.Problem(), 1).size(), 0u);
  EXPECT_EQ(IslandsInAirOf(pair.Problem(), 2), BoxOf(7, 0, 7.1, 0.1));
  EXPECT_EQ(IslandsInAirOf(pair.Problem(), 0).size(), 0u);
}

/// Tests random outlines: the steep area is exactly the area inside the layer and farther than the
/// threshold from the layer below.
TEST(OverhangOf, EqualsBruteForce) {
  std::mt19937 random(11);
  const auto blob = [&](double radius) {
    Polygon ring;
    for (int i = 0; i < 24; ++i) {
      const double angle = i * std::numbers::pi / 12,
                   r = radius * (0.7 + random() % 1'000 / 2'000.0);
      ring.push_back({FromMm(r * std::cos(angle)), FromMm(r * std::sin(angle))});
    }
    return MultiPolygon{{ring, {}}};
  };
  SupportOptions options;
  options.skip_bridges = false;
  for (int round = 0; round < 10; ++round) {
    TestStack stack(2, [&](double z) { return blob(z < 0.2 ? 6 : 7); });
    const MultiPolygon steep = OverhangOf(stack.Problem(), 1, options).steep;
    for (int i = 0; i < 2'000; ++i) {
      const Point p = {FromMm(random() % 20'000 / 1'000.0 - 10),
                       FromMm(random() % 20'000 / 1'000.0 - 10)};
      const auto& below = stack.outlines()[0][0];
      double distance = 1e18;
      for (size_t k = 0; k < below.outer.size(); ++k)
        distance = std::min(distance, DistanceToSegment(p, below.outer[k],
                                                        below.outer[(k + 1) % below.outer.size()]));
      if (Locate(p, below) == Side::kInside) distance = 0;
      const bool inside = Locate(p, stack.outlines()[1][0]) == Side::kInside;
      if (std::abs(distance - 225'000) < 15'000) continue;
      bool found = false;
      for (const auto& island : steep) found |= Locate(p, island) == Side::kInside;
      if (found) {
        EXPECT_TRUE(inside && distance > 225'000);
      } else if (inside && distance > 300'000) {
        ADD_FAILURE() << "missed, " << ToText(p);  // scraps of 0.02 mm2 are dropped
      }
    }
  }
}

TEST(OverhangThreshold, ShareOfTheWallThatMustRest) {
  SupportOptions options;
  options.threshold_overlap = 0.25;
  for (const SupportStyle style : {SupportStyle::kGrid, SupportStyle::kTree}) {
    options.style = style;
    EXPECT_EQ(OverhangThreshold(options, 200'000, 200'000), 337'500);
  }
  options.threshold_rad = std::numbers::pi / 4;
  EXPECT_EQ(OverhangThreshold(options, 200'000, 200'000), 193'138);
}

TEST(OverhangOf, CriticalRegionsAreCantileversAndIslands) {
  SupportOptions options;
  options.critical_only = true;
  EXPECT_TRUE(OverhangOf(Step(2.8).Problem(), 2, options).steep.empty());
  EXPECT_NEAR(AreaMm2(OverhangOf(Step(3.5).Problem(), 2, options).steep), (3.5 - 0.225) * 10, 0.01);
  const TestStack island(4, [](double z) {
    return z < 0.4 ? BoxOf(0, 0, 10, 10) : Union(BoxOf(0, 0, 10, 10), BoxOf(11, 0, 12, 1));
  });
  EXPECT_NEAR(AreaMm2(OverhangOf(island.Problem(), 2, options).steep), 1, 0.01);
  options.enforced_layers = 3;
  EXPECT_FALSE(OverhangOf(Step(2).Problem(), 2, options).steep.empty());
}

TEST(OverhangOf, LongBridgesAreSupported) {
  const TestStack gate(3, [](double z) {
    return z < 0.4 ? Union(BoxOf(0, 0, 2, 10), BoxOf(12, 0, 14, 10)) : BoxOf(0, 0, 14, 10);
  });
  SupportOptions options;
  options.max_bridge_nm = 11 * kNmPerMm;
  EXPECT_TRUE(OverhangOf(gate.Problem(), 2, options).steep.empty());
  options.max_bridge_nm = 9 * kNmPerMm;
  EXPECT_NEAR(AreaMm2(OverhangOf(gate.Problem(), 2, options).steep), (10 - 0.45) * 10, 0.02);
}

}  // namespace
}  // namespace slicefarm::planning::overhangs_test
