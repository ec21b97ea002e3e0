#include "services/planning/algo/supports/generator/small_overhangs.h"

#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::small_overhangs_test {
namespace {

/// Returns the overhangs of a stack without the small ones.
std::vector<Overhang> LargeOnly(const TestStack& stack, SupportOptions options = {}) {
  options.on = true;
  options.skip_bridges = false;
  const SupportProblem problem = stack.Problem();
  std::vector<Overhang> overhangs;
  for (size_t i = 0; i < problem.part.size(); ++i)
    overhangs.push_back(OverhangOf(problem, i, options));
  RemoveSmallOverhangs(problem, options, overhangs);
  return overhangs;
}

double SteepMm2(const std::vector<Overhang>& overhangs) {
  double area = 0;
  for (const Overhang& overhang : overhangs) area += AreaMm2(overhang.steep);
  return area;
}

/// Returns a block of 20 mm that is `wider` mm wider on one side from a height of 4 mm on.
TestStack Ledge(double wider) {
  return TestStack(40, [wider](double z) { return BoxOf(0, 0, z < 4 ? 20 : 20 + wider, 20); });
}

TEST(RemoveSmallOverhangs, RemovesANarrowLedge) {
  EXPECT_EQ(SteepMm2(LargeOnly(Ledge(0.8))), 0);
  for (const Overhang& overhang : LargeOnly(Ledge(0.8))) EXPECT_TRUE(overhang.contact.empty());
}

TEST(RemoveSmallOverhangs, KeepsAWideLedge) {
  EXPECT_GT(SteepMm2(LargeOnly(Ledge(1.6))), 15) << "a little wider than two walls";
  EXPECT_GT(SteepMm2(LargeOnly(Ledge(2.5))), 30);
}

// Each step of a slope is narrow, but all steps together are wide.
TEST(RemoveSmallOverhangs, KeepsASlopeOfManySteps) {
  const TestStack slope(40,
                        [](double z) { return BoxOf(0, 0, z < 2 ? 10 : 10 + 3 * (z - 2), 10); });
  EXPECT_GT(SteepMm2(LargeOnly(slope)), 50);
}

TEST(RemoveSmallOverhangs, KeepsWhatBeginsInTheAir) {
  const TestStack peg(40, [](double z) {
    MultiPolygon outline = BoxOf(0, 0, 10, 10);
    if (z > 5) outline.push_back(BoxOf(12, 2, 13, 3)[0]);
    return outline;
  });
  EXPECT_NEAR(SteepMm2(LargeOnly(peg)), 1, 1e-6);
}

TEST(RemoveSmallOverhangs, KeepsALongThinArm) {
  const TestStack arm(40, [](double z) {
    return z < 4 ? BoxOf(0, 0, 10, 10) : Union(BoxOf(0, 0, 10, 10), BoxOf(9, 4, 18, 5));
  });
  EXPECT_GT(SteepMm2(LargeOnly(arm)), 5);
}

TEST(RemoveSmallOverhangs, KeepsEnforcedLayers) {
  SupportOptions options;
  options.enforced_layers = 30;
  EXPECT_GT(SteepMm2(LargeOnly(Ledge(0.8), options)), 5);
}

}  // namespace
}  // namespace slicefarm::planning::small_overhangs_test
