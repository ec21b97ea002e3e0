#include "services/planning/algo/supports/generator/branch_drawing.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::branch_drawing_test {
namespace {

constexpr int kLayers = 30;

SupportHeights Even() {
  SupportHeights heights;
  for (Coord i = 0; i < kLayers; ++i) heights.layers.push_back({i * 200'000, (i + 1) * 200'000});
  return heights;
}

std::vector<BranchSections> Draw(const SupportProblem& problem, const Branches& branches,
                                 int threads = 1) {
  const SupportOptions options;
  const SupportHeights heights = Even();
  const Clearance clearance(problem, options, 100'000'000, 1);
  const auto field =
      ReachField::Make(problem, heights, {{-9'000'000, -9'000'000}, {9'000'000, 9'000'000}},
                       options, 1, CancelToken());
  return DrawBranches(branches, *field, heights, clearance, options, threads, CancelToken());
}

const TestStack kNothing(kLayers, [](double) { return MultiPolygon(); });

/// Returns a branch from (0, 0) at 6 mm to (2, 0) at 3 mm, then straight down.
Branches Leaning(Coord radius_nm) {
  Branches branches;
  branches.nodes.push_back({{0, 0}, 6'000'000, radius_nm, 1, 0, true});
  branches.nodes.push_back({{2'000'000, 0}, 3'000'000, radius_nm, -1, 0, true});
  return branches;
}

TEST(DrawBranches, DiscsLieOnTheLineBetweenNodes) {
  const auto sections = Draw(kNothing.Problem(), Leaning(1'000'000));
  for (size_t i = 6; i < kLayers; ++i) {
    ASSERT_EQ(sections[i].thin.size(), 1u) << i;
    EXPECT_TRUE(sections[i].thick.empty());
    EXPECT_NEAR(AreaMm2(sections[i].thin), std::numbers::pi, 0.05);
    const double z = 0.2 * static_cast<double>(i) + 0.1;
    const Point middle = Centroid(sections[i].thin[0].outer);
    EXPECT_NEAR(ToMm(middle.x), z < 3 ? 2 : 2 * (6 - z) / 3, 1e-5);
  }
  EXPECT_NEAR(AreaMm2(sections[0].thin) + AreaMm2(sections[0].thick), std::numbers::pi * 6.25, 0.3);
}

TEST(DrawBranches, ThickOnesAreToldApart) {
  const auto sections = Draw(kNothing.Problem(), Leaning(1'600'000));
  EXPECT_TRUE(sections[20].thin.empty());
  EXPECT_NEAR(AreaMm2(sections[20].thick), std::numbers::pi * 2.56, 0.1);
}

TEST(DrawBranches, ArePutTogetherAndCutToWhatIsFree) {
  const TestStack wall(kLayers, [](double) { return BoxOf(2.5, -9, 9, 9); });
  Branches branches = Leaning(1'000'000);
  branches.nodes.push_back({{0, 500'000}, 6'000'000, 1'000'000, -1, 0, true});
  const auto sections = Draw(wall.Problem(), branches);
  for (const BranchSections& section : sections) {
    EXPECT_LE(section.thin.size(), 2u);
    for (const auto& island : section.thin)
      EXPECT_LE(Bounds(island.outer).max.x, 2'500'000 - 225'000 + 10);
  }
  EXPECT_EQ(sections[29].thin.size(), 1u);
  EXPECT_EQ(sections, Draw(wall.Problem(), branches, 5));
}

/// Returns two upright branches of 1.6 mm, 2.4 mm apart.
Branches Pair() {
  Branches branches;
  branches.nodes.push_back({{-1'200'000, 0}, 6'000'000, 800'000, -1, 0, true});
  branches.nodes.push_back({{1'200'000, 0}, 6'000'000, 800'000, -1, 0, true});
  return branches;
}

TEST(DrawBranches, NeighboursAreOneIsland) {
  const auto sections = Draw(kNothing.Problem(), Pair());
  for (size_t i = 0; i < kLayers; ++i) {
    EXPECT_EQ(sections[i].thin.size() + sections[i].thick.size(), 1u) << i;
    if (i > 6) {
      EXPECT_TRUE(sections[i].thick.empty()) << i;
    }
  }
}

TEST(DrawBranches, NecksKeepOffThePart) {
  const TestStack roof(kLayers,
                       [](double z) { return z > 5 ? BoxOf(-0.3, -9, 0.3, 9) : MultiPolygon(); });
  const auto sections = Draw(roof.Problem(), Pair());
  EXPECT_EQ(sections[10].thin.size(), 1u);
  for (const size_t i : {23u, 28u}) EXPECT_EQ(sections[i].thin.size(), 2u) << i;
}

}  // namespace
}  // namespace slicefarm::planning::branch_drawing_test
