#include "services/milling/algo/strategy/rest_rows.h"

#include <gtest/gtest.h>

#include "services/milling/algo/drop/drop_cutter.h"
#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::rest_rows_test {
namespace {

std::vector<std::vector<RestRun>> RowsOf(const MillingJob& job, const std::vector<double>& y) {
  auto rows = RestRows(job, y, {});
  EXPECT_TRUE(rows.ok()) << rows.status();
  return *std::move(rows);
}

/// The row crosses the pocket's middle: the rim, the floor, the island, the floor, the rim, the
/// step.
TEST(RestRows, LieOnFlatsAndNotOnWalls) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:1"));
  const std::vector<RestRun> runs = RowsOf(job, {4})[0];
  std::vector<double> heights;
  for (const RestRun& run : runs) {
    for (const Eigen::Vector3d& p : run) EXPECT_NEAR(p.z(), run[0].z(), 1e-6);
    heights.push_back(run[0].z());
  }
  ASSERT_EQ(heights.size(), 6u);
  const double wanted[] = {3, 1, 2, 1, 3, 2};
  for (size_t i = 0; i < heights.size(); ++i) EXPECT_NEAR(heights[i], wanted[i], 1e-6);
}

/// On waves the tip is within a tenth of the tolerance of its rest position, also between points.
TEST(RestRows, FollowTheSurface) {
  for (const std::string_view text : {"ball:1", "bull:1:0.2", "cyl:1", "cone:1:60"}) {
    MillingOptions options = OptionsFor(text);
    options.open_mesh = true;
    options.rest_angle_deg = 60;
    const MillingJob job = JobOf(Waves(7, 30), options);
    const DropCutter dropper(job.part, options.cutter);
    size_t points = 0;
    for (const auto& row : RowsOf(job, {1.1, 3.3, 5})) {
      for (const RestRun& run : row) {
        for (size_t i = 0; i + 1 < run.size(); ++i, ++points) {
          for (const double share : {0.0, 0.3, 0.5, 0.8}) {
            const Eigen::Vector3d p = run[i] + share * (run[i + 1] - run[i]);
            const auto drop = dropper.At(p.head<2>());
            ASSERT_TRUE(drop.has_value());
            EXPECT_NEAR(p.z(), std::max(drop->z_mm, job.floor_mm), 0.4 * options.tolerance_mm)
                << text << p.transpose();
          }
        }
      }
    }
    EXPECT_GT(points, 30u) << text;
  }
}

/// The row crosses a low step, at any position between the samples and for any distance of the
/// samples. The cutter reduced by the tolerance must meet nothing.
TEST(RestRows, DoNotCutTheFootOfAStep) {
  int tested = 0;
  for (const std::string_view text : {"bull:2:0.5", "ball:2", "cyl:2"}) {
    for (const double stepover : {0.25, 0.7}) {
      for (int shift = 0; shift < 25; ++shift) {
        MillingOptions options = OptionsFor(text);
        options.finish_stepover_mm = stepover;
        TriangleMesh step = Pillars{.heights = {{2, 2.3, 2.3}}, .side = 4}.Mesh();
        for (Eigen::Vector3d& p : step.points_mm)
          if (p.x() == 4) p.x() += 0.013 * shift;
        const MillingJob job = JobOf(step, options);
        const GrownCutter less = options.cutter.Grown(-options.tolerance_mm);
        const DropCutter dropper(job.part, less.cutter);
        const std::vector<RestRun> runs = RowsOf(job, {2})[0];
        for (const RestRun& run : runs) {
          for (size_t i = 0; i + 1 < run.size(); ++i) {
            for (double share = 0; share <= 1; share += 1 / 16.0) {
              ++tested;
              const Eigen::Vector3d tip = run[i] + share * (run[i + 1] - run[i]);
              const auto drop = dropper.At(tip.head<2>());
              ASSERT_LE(drop ? drop->z_mm : 0, tip.z() + less.tip_mm)
                  << text << " " << stepover << " " << shift << ": " << tip.transpose();
            }
          }
        }
      }
    }
  }
  EXPECT_GT(tested, 0);
}

TEST(RestRows, StopWhenCancelled) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:1"));
  const auto rows = RestRows(job, std::vector<double>{1, 2}, CancelToken([] { return true; }));
  EXPECT_EQ(rows.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::milling::rest_rows_test
