#include "services/milling/algo/strategy/milling_job.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::milling_job_test {
namespace {

std::vector<double> PositionsOf(const MillingJob& job, MillPhase phase) {
  std::vector<double> positions;
  for (const MillStep& step : job.steps)
    if (step.phase == phase) positions.push_back(step.at_mm);
  return positions;
}

/// The flats are at 1, 2 and 3 mm and the stock is from 0 to 4 mm. There are levels on each flat,
/// at its allowance, and between them.
TEST(PrepareMilling, PutsLevelsOnFlatsAndEvenlyBetween) {
  MillingOptions options = OptionsFor("cyl:1");
  options.stepdown_mm = 0.5;
  options.allowance_mm = 0.2;
  options.finish_stepdown_mm = 0.5;
  const MillingJob job = JobOf(PocketPart().Mesh(), options);
  const std::vector<double> roughing = PositionsOf(job, MillPhase::kRoughing);
  const std::vector<double> wanted = {3.6, 3.2, 2.7, 2.2, 1.7, 1.2, 0.8, 0.4, 0};
  ASSERT_EQ(roughing.size(), wanted.size());
  for (size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(roughing[i], wanted[i], 1e-12);
  const std::vector<double> finishing = PositionsOf(job, MillPhase::kFinishing);
  for (const double flat : {1.0, 2.0, 0.0})
    EXPECT_NE(std::find(finishing.begin(), finishing.end(), flat), finishing.end()) << flat;
  EXPECT_LT(finishing.front(), 3);  // no part is above its top
  EXPECT_FALSE(PositionsOf(job, MillPhase::kRest).empty());
}

TEST(PrepareMilling, LeavesFinishingOut) {
  MillingOptions options = OptionsFor("cyl:1");
  options.finishing = false;
  const MillingJob job = JobOf(PocketPart().Mesh(), options);
  ASSERT_FALSE(job.steps.empty());
  for (const MillStep& step : job.steps) EXPECT_EQ(step.phase, MillPhase::kRoughing);
}

Reason ReasonOf(const TriangleMesh& part, const MillingOptions& options,
                std::optional<TriangleMesh> stock = std::nullopt) {
  return DetailOf(PrepareMilling(part, std::move(stock), options).status()).reason;
}

TEST(PrepareMilling, RefusesWhatIsNoWork) {
  const TriangleMesh part = PocketPart().Mesh();
  EXPECT_EQ(ReasonOf({}, OptionsFor("cyl:1")), Reason::kMeshEmpty);
  EXPECT_EQ(ReasonOf(part, OptionsFor("cyl:12")), Reason::kSettingOutOfRange);
  TriangleMesh open = part;
  open.triangles.pop_back();
  EXPECT_EQ(ReasonOf(open, OptionsFor("cyl:1")), Reason::kMeshMalformed);
  MillingOptions surface = OptionsFor("cyl:1");
  surface.open_mesh = true;
  EXPECT_TRUE(PrepareMilling(open, std::nullopt, surface).ok());
  TriangleMesh broken = part;
  broken.points_mm[3].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ReasonOf(broken, OptionsFor("cyl:1")), Reason::kMeshNotFinite);
  for (const double bottom : {3.0, 5.0, -1.0}) {
    MillingOptions options = OptionsFor("cyl:1");
    options.bottom_mm = bottom;
    EXPECT_EQ(ReasonOf(part, options), Reason::kSettingOutOfRange) << bottom;
  }
  MillingOptions tool = OptionsFor("cyl:1");
  tool.machining.tool_length_mm = 3;
  EXPECT_EQ(ReasonOf(part, tool), Reason::kSettingOutOfRange);
  MillingOptions many = OptionsFor("cyl:1");
  many.finish_stepdown_mm = 0.001;
  many.finish_stepover_mm = 0.001;
  EXPECT_TRUE(PrepareMilling(part, std::nullopt, many).ok());
  MillingOptions dense = OptionsFor("cyl:0.1");
  dense.stepover_share = 0.01;
  dense.finish_stepover_mm = 0.05;
  EXPECT_EQ(ReasonOf(part, dense), Reason::kRequestTooLarge);
  TriangleMesh high = part;
  for (Eigen::Vector3d& p : high.points_mm) p *= 120;
  EXPECT_EQ(ReasonOf(high, many), Reason::kRequestTooLarge);
  for (Eigen::Vector3d& p : high.points_mm) p *= 2;
  EXPECT_EQ(ReasonOf(high, OptionsFor("cyl:1")), Reason::kOutOfRange);
}

TEST(PrepareMilling, TakesStockOfItsOwnThatHoldsThePart) {
  const TriangleMesh part = PocketPart().Mesh();
  const Pillars block{.heights = {{5}}, .side = 9};
  EXPECT_TRUE(PrepareMilling(part, block.Mesh(), OptionsFor("cyl:1")).ok());
  const Pillars low{.heights = {{2.5}}, .side = 9};
  EXPECT_EQ(ReasonOf(part, OptionsFor("cyl:1"), low.Mesh()), Reason::kOutOfRange);
  TriangleMesh open = block.Mesh();
  open.triangles.pop_back();
  EXPECT_EQ(ReasonOf(part, OptionsFor("cyl:1"), open), Reason::kMeshMalformed);
}

}  // namespace
}  // namespace slicefarm::milling::milling_job_test
