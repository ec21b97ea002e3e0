#include "services/planning/algo/supports/generator/clearance.h"

#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::clearance_test {
namespace {

struct Case {
  std::string name;
  Coord bottom_nm;
  Coord top_nm;
  /// Start of free space, to the right of a box that ends at 5 mm; 10: no free space.
  double left_mm;
};

class ClearanceTest : public testing::TestWithParam<Case> {};

/// A box from 0 to 5 mm, 2 to 4 mm high. The gap is 0.2 above and 0.3 below supports.
TEST_P(ClearanceTest, IsExact) {
  const TestStack box(20, [](double z) { return z > 2 ? BoxOf(0, 0, 5, 5) : MultiPolygon(); });
  const SupportProblem problem = box.Problem();
  SupportOptions options;
  options.bottom_gap_nm = 300'000;
  const Clearance clearance(problem, options, 100'000'000, 1);
  const MultiPolygon free =
      clearance.Free(BoxOf(0, 1, 10, 2), GetParam().bottom_nm, GetParam().top_nm);
  EXPECT_NEAR(AreaMm2(free), 10 - GetParam().left_mm, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Box, ClearanceTest,
                         testing::Values(Case{"FarBelow", 1'000'000, 1'200'000, 0},
                                         Case{"AtTheGap", 1'600'000, 1'800'000, 0},
                                         Case{"NearerThanTheGap", 1'650'000, 1'850'000, 5.008},
                                         Case{"Touching", 1'800'000, 2'000'000, 5.008},
                                         Case{"Beside", 1'900'000, 2'100'000, 5.225},
                                         Case{"OnTop", 4'000'000, 4'200'000, 5.008},
                                         Case{"NearTheTop", 4'200'000, 4'400'000, 5.008},
                                         Case{"AtTheLowerGap", 4'300'000, 4'500'000, 0}),
                         [](const auto& info) { return info.param.name; });

// Only the layer of the part on the bed has the gap of the first layer.
TEST(Clearance, HasAGapOfItsOwnInTheFirstLayer) {
  const TestStack box(20, [](double) { return BoxOf(0, 0, 5, 5); });
  const SupportProblem problem = box.Problem();
  SupportOptions options;
  options.first_xy_gap_nm = 600'000;
  const Clearance clearance(problem, options, 100'000'000, 1);
  const auto free_mm = [&](Coord bottom_nm, Coord top_nm) {
    return AreaMm2(clearance.Free(BoxOf(0, 1, 10, 2), bottom_nm, top_nm));
  };
  EXPECT_NEAR(free_mm(0, 200'000), 10 - 5.6, 1e-6);
  EXPECT_NEAR(free_mm(1'000'000, 1'200'000), 10 - 5.225, 1e-6);
}

TEST(Clearance, KeepsOffOthersAndOnTheBed) {
  const TestStack nothing(5, [](double) { return MultiPolygon(); });
  const TestStack other(5, [](double) { return BoxOf(0, 0, 5, 5); });
  SupportProblem problem = nothing.Problem();
  problem.others.push_back(other.Layers());
  problem.bed = BoxOf(-5, -5, 8, 8);
  const SupportOptions options;
  const Clearance clearance(problem, options, 100'000'000, 1);
  EXPECT_NEAR(AreaMm2(clearance.Free(BoxOf(0, 1, 10, 2), 200'000, 400'000)), 3 - 0.225, 1e-6);
}

}  // namespace
}  // namespace slicefarm::planning::clearance_test
