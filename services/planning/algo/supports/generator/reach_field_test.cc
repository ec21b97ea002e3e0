#include "services/planning/algo/supports/generator/reach_field.h"

#include <gtest/gtest.h>

#include <random>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::reach_field_test {
namespace {

SupportHeights Even(int layers) {
  SupportHeights heights;
  for (Coord i = 0; i < layers; ++i) heights.layers.push_back({i * 200'000, (i + 1) * 200'000});
  return heights;
}

absl::StatusOr<ReachField> FieldOf(const SupportProblem& problem, int layers,
                                   const SupportOptions& options, int threads = 1) {
  return ReachField::Make(problem, Even(layers),
                          {{-20'000'000, -20'000'000}, {20'000'000, 20'000'000}}, options, threads,
                          CancelToken());
}

Point At(double x, double y) { return {FromMm(x), FromMm(y)}; }

TEST(MostWithin, EqualsBruteForce) {
  const PixelGrid grid = {{0, 0}, 1, 41, 23};
  std::mt19937 random(3);
  std::vector<PixelDistance> values(grid.size());
  for (PixelDistance& value : values) value = static_cast<PixelDistance>(random() % 256);
  for (const int32_t squared : {0, 1, 2, 4, 5, 8}) {
    const auto most = MostWithin(values, grid, squared);
    for (int32_t y = 0; y < grid.height; ++y) {
      for (int32_t x = 0; x < grid.width; ++x) {
        int want = 0;
        for (int32_t v = 0; v < grid.height; ++v)
          for (int32_t u = 0; u < grid.width; ++u)
            if ((u - x) * (u - x) + (v - y) * (v - y) <= squared)
              want = std::max<int>(want, values[static_cast<size_t>(v * grid.width + u)]);
        ASSERT_EQ(most[static_cast<size_t>(y * grid.width + x)], want);
      }
    }
  }
}

TEST(SlabsOf, StepsAddUpToTheAngle) {
  for (const double degrees : {10.0, 25.0, 40.0, 60.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto slabs = SlabsOf(Even(200), angle, ReachField::kPixelNm);
    double path = 0;
    for (const Slab& slab : slabs) path += std::sqrt(slab.step_squared) * ReachField::kPixelNm;
    const double rise = slabs.back().middle_nm() - slabs.front().middle_nm();
    EXPECT_LE(path, std::tan(angle) * rise + 1) << degrees;
    EXPECT_GE(path, std::tan(angle) * rise * 0.8) << degrees;
    EXPECT_EQ(slabs.front().bottom_nm, 0);
    EXPECT_EQ(slabs.back().top_nm, 40'000'000);
  }
}

TEST(ReachField, FreeSpaceReachesTheBedEverywhere) {
  const TestStack nothing(50, [](double) { return MultiPolygon(); });
  const SupportProblem problem = nothing.Problem();
  const auto field = FieldOf(problem, 50, {});
  ASSERT_TRUE(field.ok());
  EXPECT_GT(field->ToBed(field->slabs().size() - 1, At(3, 4)), FromMm(7));
}

/// A plate of 20 x 20 mm, 4 to 6 mm above the bed, and the supports above it.
class PlateTest : public testing::Test {
 protected:
  const TestStack plate_{
      60, [](double z) { return z > 4 && z < 6 ? BoxOf(-10, -10, 10, 10) : MultiPolygon(); }};
  const SupportProblem problem_ = plate_.Problem();
};

TEST_F(PlateTest, AboveItBranchesMustGetPastItsEdge) {
  SupportOptions options;
  options.bed_only = true;
  const auto field = FieldOf(problem_, 60, options);
  ASSERT_TRUE(field.ok());
  // At 12 mm: 5.9 mm above the plate, 4.9 mm sideways.
  const size_t top = field->slabs().size() - 1;
  EXPECT_EQ(field->ToBed(top, At(0, 0)), 0);
  EXPECT_EQ(field->ToBed(top, At(4.5, 0)), 0);
  EXPECT_GT(field->ToBed(top, At(7, 0)), FromMm(0.4));
  EXPECT_EQ(field->ToBed(top, At(0, 4.5)), 0);
  EXPECT_GT(field->ToBed(top, At(0, -7)), FromMm(0.4));
  EXPECT_GT(field->ToBed(0, At(0, 0)), FromMm(7));
}

TEST_F(PlateTest, OrStandOnItWhereAllowed) {
  const auto field = FieldOf(problem_, 60, {});
  ASSERT_TRUE(field.ok());
  const size_t top = field->slabs().size() - 1;
  EXPECT_EQ(field->ToBed(top, At(0, 0)), 0);
  EXPECT_GT(field->ToAnywhere(top, At(0, 0)), FromMm(5));
}

TEST_F(PlateTest, OtherObjectsAreNoPlaceToStand) {
  const TestStack nothing(60, [](double) { return MultiPolygon(); });
  SupportProblem problem = nothing.Problem();
  problem.others.push_back(plate_.Layers());
  const auto field = FieldOf(problem, 60, {});
  ASSERT_TRUE(field.ok());
  EXPECT_EQ(field->ToAnywhere(field->slabs().size() - 1, At(0, 0)), 0);
}

TEST_F(PlateTest, BranchesStayOnTheBed) {
  SupportProblem problem = problem_;
  problem.bed = BoxOf(-20, -20, 3, 20);
  const auto field = FieldOf(problem, 60, {});
  ASSERT_TRUE(field.ok());
  EXPECT_EQ(field->ToAnywhere(0, At(3.2, 0)), 0);
  EXPECT_NEAR(field->ToAnywhere(0, At(0.125, 0.125)), FromMm(2.65), FromMm(0.15));
}

TEST_F(PlateTest, SameForAnyThreads) {
  const auto one = FieldOf(problem_, 60, {}, 1), many = FieldOf(problem_, 60, {}, 7);
  ASSERT_TRUE(one.ok() && many.ok());
  for (size_t s = 0; s < one->slabs().size(); ++s)
    for (double x = -19; x < 19; x += 0.5)
      for (double y = -19; y < 19; y += 0.5) {
        ASSERT_EQ(one->ToBed(s, At(x, y)), many->ToBed(s, At(x, y)));
        ASSERT_EQ(one->ToAnywhere(s, At(x, y)), many->ToAnywhere(s, At(x, y)));
      }
}

TEST_F(PlateTest, CanBeCancelled) {
  const auto field = ReachField::Make(problem_, Even(60), {{0, 0}, {1'000'000, 1'000'000}}, {}, 1,
                                      CancelToken([] { return true; }));
  EXPECT_EQ(field.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::planning::reach_field_test
