#include "services/milling/algo/output/mill_report.h"

#include <gtest/gtest.h>

#include <numbers>

#include "services/milling/algo/motion/mill_clock.h"
#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::mill_report_test {
namespace {

MillingJob ReportJob() { return JobOf(PocketPart().Mesh(), OptionsFor("cyl:2")); }

TEST(ReportOf, SumsByPhase) {
  const MillingJob job = ReportJob();
  const MillProgram program{
      .moves = {{.to_mm = {-5, -5, 9}},
                {.to_mm = {-5, -5, 4}},
                {.kind = MoveKind::kLine, .to_mm = {-2, -5, 4}, .feed_mm_min = 600},
                {.kind = MoveKind::kClockwise,
                 .phase = MillPhase::kFinishing,
                 .to_mm = {-4, -5, 4},
                 .centre_mm = {-3, -5},
                 .feed_mm_min = 600}},
      .safe_z_mm = 9,
      .passes = 2,
      .removed_mm3 = 5};
  const auto report = ReportOf(job, program);
  ASSERT_TRUE(report.ok());
  EXPECT_NEAR(report->phases[0].rapid_mm, 5, 1e-12);
  EXPECT_NEAR(report->phases[0].cut_mm, 3, 1e-12);
  const std::vector<MoveTime> times = TimesOf(program.moves, job.options);
  EXPECT_NEAR(report->phases[0].seconds, times[1].seconds + times[2].seconds, 1e-12);
  EXPECT_NEAR(report->phases[1].seconds, times[3].seconds, 1e-12);
  EXPECT_NEAR(report->phases[1].cut_mm, std::numbers::pi, 1e-12);
  EXPECT_EQ(report->phases[1].arcs, 1u);
  EXPECT_EQ(report->passes, 2);
  EXPECT_EQ(report->gouges, 0u);
}

/// A move 0.02 mm too deep over the rim is a gouge; one 0.005 mm too deep is within the tolerance.
/// The same distances apply to moves into its wall.
TEST(ReportOf, FindsGouges) {
  const MillingJob job = ReportJob();
  const auto gouges = [&](Eigen::Vector3d from, Eigen::Vector3d to) {
    const MillProgram program{
        .moves = {{.to_mm = from}, {.kind = MoveKind::kLine, .to_mm = to, .feed_mm_min = 600}},
        .safe_z_mm = 9};
    return ReportOf(job, program)->gouges > 0;
  };
  EXPECT_FALSE(gouges({-2, 0.5, 2.995}, {12, 0.5, 2.995}));
  EXPECT_TRUE(gouges({-2, 0.5, 2.98}, {12, 0.5, 2.98}));
  EXPECT_FALSE(gouges({-0.995, 0, 1}, {-0.995, 8, 1}));
  EXPECT_TRUE(gouges({-0.98, 0, 1}, {-0.98, 8, 1}));
}

TEST(ReportOf, StopsWhenCancelled) {
  const MillingJob job = ReportJob();
  const MillProgram program = ProgramOf(job);
  EXPECT_EQ(ReportOf(job, program, CancelToken([] { return true; })).status().code(),
            absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::milling::mill_report_test
