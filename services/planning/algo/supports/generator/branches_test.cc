#include "services/planning/algo/supports/generator/branches.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/base/portable_math.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::branches_test {
namespace {

constexpr int kLayers = 100;  // 20 mm high

/// Branches under a square of `side` mm around the origin, below the top of the given number of
/// layers.
class GrownBranches {
 public:
  GrownBranches(const SupportProblem& problem, const SupportOptions& options, double side,
                int layers = kLayers)
      : undersides_(static_cast<size_t>(layers)) {
    for (Coord i = 0; i < layers; ++i) heights_.layers.push_back({i * 200'000, (i + 1) * 200'000});
    field_ =
        ReachField::Make(problem, heights_, {{-25'000'000, -25'000'000}, {25'000'000, 25'000'000}},
                         options, 1, CancelToken());
    Bitmap square(field_->grid());
    square.Fill(BoxOf(-side / 2, -side / 2, side / 2, side / 2));
    for (size_t i = 0; i < square.grid().size(); ++i)
      if (square.Row(0)[i]) undersides_.back().push_back(static_cast<int32_t>(i));
    branches_ = GrowBranches(*field_, heights_, undersides_, options, CancelToken());
  }
  const Branches& branches() const { return *branches_; }
  const ReachField& field() const { return *field_; }
  size_t Feet() const {
    size_t feet = 0;
    for (const BranchNode& node : branches().nodes) feet += node.below < 0 ? 1 : 0;
    return feet;
  }
  size_t Tips() const {
    std::vector<bool> above(branches().nodes.size());
    for (const BranchNode& node : branches().nodes)
      if (node.below >= 0) above[static_cast<size_t>(node.below)] = true;
    return static_cast<size_t>(std::count(above.begin(), above.end(), false));
  }

 private:
  SupportHeights heights_;
  std::vector<std::vector<int32_t>> undersides_;
  absl::StatusOr<ReachField> field_ = absl::UnknownError("");
  absl::StatusOr<Branches> branches_ = absl::UnknownError("");
};

const TestStack kNothing(kLayers, [](double) { return MultiPolygon(); });

TEST(GrowBranches, OneTipStandsUprightAndWidens) {
  const GrownBranches growth(kNothing.Problem(), {}, 0.5);
  EXPECT_EQ(growth.Tips(), 1u);
  EXPECT_EQ(growth.Feet(), 1u);
  Coord radius = 0;
  for (const BranchNode& node : growth.branches().nodes) {
    EXPECT_EQ(node.at, growth.branches().nodes[0].at);
    EXPECT_GE(node.radius_nm, radius);
    radius = node.radius_nm;
  }
  EXPECT_EQ(growth.branches().nodes[0].radius_nm, 400'000);
  EXPECT_NEAR(radius, 1e6 + 19.6e6 * 0.75 * std::tan(5 * std::numbers::pi / 180), 0.02e6);
}

TEST(GrowBranches, TheyMeetToFewFeet) {
  const GrownBranches growth(kNothing.Problem(), {}, 8);
  EXPECT_GT(growth.Tips(), 12u);
  EXPECT_LE(growth.Feet(), 3u);
}

TEST(GrowBranches, TheyMeetUnderALowPlateToo) {
  const GrownBranches growth(kNothing.Problem(), {}, 30, 30);
  EXPECT_GT(growth.Tips(), 80u);
  EXPECT_LT(growth.Feet(), growth.Tips() / 3);
}

TEST(GrowBranches, NearTheBedTheyLeaveRoomForAFoot) {
  const TestStack wall(kLayers,
                       [](double z) { return z < 19 ? BoxOf(-9, -9, -0.6, 9) : MultiPolygon(); });
  const GrownBranches growth(wall.Problem(), {}, 0.5);
  ASSERT_GT(growth.Feet(), 0u);
  for (const BranchNode& node : growth.branches().nodes) {
    if (node.below < 0) {
      EXPECT_GE(node.at.x, -600'000 + 225'000 + kFootRadiusNm - 250'000);
    }
  }
}

TEST(GrowBranches, NoneLeansMoreThanTheAngle) {
  for (const double degrees : {25.0, 40.0, 55.0}) {
    SupportOptions options;
    options.tree.angle_rad = degrees * std::numbers::pi / 180;
    const GrownBranches growth(kNothing.Problem(), options, 10);
    int steps = 0;
    for (const BranchNode& node : growth.branches().nodes) {
      if (node.below < 0) continue;
      ++steps;
      const BranchNode& below = growth.branches().nodes[static_cast<size_t>(node.below)];
      // Places are pixels, so each step may be longer by one pixel's diagonal.
      EXPECT_LE(Distance(node.at, below.at),
                std::tan(options.tree.angle_rad) * (node.z_nm - below.z_nm) + 600'000);
      EXPECT_LT(below.z_nm, node.z_nm);
    }
    EXPECT_GT(steps, 0) << degrees;
  }
}

TEST(GrowBranches, GoAroundWhatIsInTheWay) {
  const TestStack plate(
      kLayers, [](double z) { return z > 4 && z < 5 ? BoxOf(-6, -6, 6, 6) : MultiPolygon(); });
  SupportOptions options;
  options.bed_only = true;
  const GrownBranches growth(plate.Problem(), options, 6);
  EXPECT_EQ(growth.branches().lost, 0);
  for (const BranchNode& node : growth.branches().nodes) {
    EXPECT_TRUE(node.on_bed);
    if (node.z_nm > 4'000'000 && node.z_nm < 5'000'000) {
      EXPECT_GT(std::max(std::abs(node.at.x), std::abs(node.at.y)), 6'000'000 + 225'000 + 300'000);
    }
  }
}

TEST(GrowBranches, WhatCannotStandIsLost) {
  const TestStack plate(kLayers, [](double z) {
    return z > 10 && z < 11 ? BoxOf(-20, -20, 20, 20) : MultiPolygon();
  });
  SupportOptions options;
  EXPECT_EQ(GrownBranches(plate.Problem(), options, 6).branches().lost, 0);
  options.bed_only = true;
  const GrownBranches growth(plate.Problem(), options, 6);
  EXPECT_GT(growth.branches().lost, 5);
  EXPECT_TRUE(growth.branches().nodes.empty());
}

TEST(GrowBranches, CanBeCancelled) {
  SupportHeights heights;
  heights.layers.push_back({0, 200'000});
  const SupportProblem problem = kNothing.Problem();
  const auto field =
      ReachField::Make(problem, heights, {{0, 0}, {1'000'000, 1'000'000}}, {}, 1, CancelToken());
  const auto branches = GrowBranches(*field, heights, {{}}, {}, CancelToken([] { return true; }));
  EXPECT_EQ(branches.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::planning::branches_test
