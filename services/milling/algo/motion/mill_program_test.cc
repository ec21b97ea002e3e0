#include "services/milling/algo/motion/mill_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "services/milling/algo/height_map_oracle_test.h"
#include "services/milling/algo/output/mill_report.h"
#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::mill_program_test {
namespace {

MillingOptions FineOptions(std::string_view cutter) {
  MillingOptions options = OptionsFor(cutter);
  options.sampling_mm = 0.1;
  options.finish_stepdown_mm = 0.2;
  options.finish_stepover_mm = 0.15;
  options.finish_floor = true;
  return options;
}

struct ProgramCase {
  const char* cutter;
  EntryKind entry = EntryKind::kHelix;
  CutDirection direction = CutDirection::kClimb;
  double left = 0.05;  ///< height of scallops
};

/// There must be no gouge, no rapid move through stock, and no reachable stock left.
TEST(MillProgram, LeavesThePart) {
  const Pillars part = PocketPart();
  const auto height = [&](double x, double y) { return part.HeightAt(x, y); };
  for (const ProgramCase& c : {
           ProgramCase{"cyl:1.5"},
           ProgramCase{"ball:1.5", EntryKind::kRamp},
           ProgramCase{"bull:1.8:0.3", EntryKind::kPlunge, CutDirection::kConventional},
           ProgramCase{"cone:1.5:30", EntryKind::kHelix, CutDirection::kConventional, 0.2},
           ProgramCase{"ballcone:0.8:15:1.6"},
       }) {
    MillingOptions options = FineOptions(c.cutter);
    options.machining.entry = c.entry;
    options.machining.direction = c.direction;
    const MillingJob job = JobOf(part.Mesh(), options);
    const MillProgram program = ProgramOf(job);
    HeightMapOracle oracle(job, height);
    oracle.Run(program);
    EXPECT_LT(oracle.Gouge(), 0.012) << c.cutter;
    EXPECT_EQ(oracle.rapid_in_stock(), 0) << c.cutter;
    EXPECT_LT(oracle.LeftReachable(), c.left) << c.cutter << " at " << oracle.left_at().transpose();
    EXPECT_GE(oracle.deepest_tip(), job.floor_mm) << c.cutter;
    const auto report = ReportOf(job, program);
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(report->gouges, 0u) << c.cutter;
  }
}

/// The part is a ball on a plate, so slopes of all angles occur.
TEST(MillProgram, LeavesRoundParts) {
  MillingOptions options = FineOptions("ball:1.5");
  options.open_mesh = true;
  options.bottom_mm = 2;  // the ball reaches through the plate
  TriangleMesh part = Pillars{.heights = {{1}}, .side = 9}.Mesh();
  TriangleMesh ball = Sphere(3, 96);
  for (Eigen::Vector3d& p : ball.points_mm) p += Eigen::Vector3d(4.5, 4.5, 1);
  Append(part, ball);
  const MillingJob job = JobOf(part, options);
  HeightMapOracle oracle(job, [](double x, double y) {
    if (x < 0 || y < 0 || x > 9 || y > 9) return 0.0;
    const double square = 9 - (x - 4.5) * (x - 4.5) - (y - 4.5) * (y - 4.5);
    return square > 0 ? 1 + std::sqrt(square) : 1;
  });
  oracle.Run(ProgramOf(job));
  EXPECT_LT(oracle.Gouge(), 0.015);
  EXPECT_EQ(oracle.rapid_in_stock(), 0);
  EXPECT_LT(oracle.LeftReachable(), 0.06);
}

/// Roughing alone leaves the allowance, and at most one step more.
TEST(MillProgram, RoughingLeavesTheAllowance) {
  MillingOptions options = FineOptions("cyl:1.5");
  options.finishing = false;
  options.allowance_mm = 0.3;
  const Pillars part = PocketPart();
  const MillingJob job = JobOf(part.Mesh(), options);
  HeightMapOracle oracle(job, [&](double x, double y) {
    double height = 0;  // the part grown by slightly less than the allowance
    for (const double dx : {-0.25, 0.0, 0.25})
      for (const double dy : {-0.25, 0.0, 0.25})
        height = std::max(height, part.HeightAt(x + dx / 1.5, y + dy / 1.5) +
                                      (part.HeightAt(x, y) > 0 ? 0.25 : 0));
    return height;
  });
  oracle.Run(ProgramOf(job));
  EXPECT_LT(oracle.Gouge(), 0.01);
  EXPECT_EQ(oracle.rapid_in_stock(), 0);
}

/// Holes 0.2 mm wider than the cutter, such as screw holes, are milled without finer sampling.
TEST(MillProgram, ReachesHolesALittleWiderThanTheCutter) {
  for (const double side : {3.2, 3.37}) {
    const Pillars plate{.heights = {{3, 3, 3}, {3, 1, 3}, {3, 3, 3}}, .side = side};
    MillingOptions options = OptionsFor(side < 3.3 ? "cyl:3" : "cyl:3.2");
    options.finish_floor = true;
    const MillingJob job = JobOf(plate.Mesh(), options);
    HeightMapOracle oracle(job, [&](double x, double y) { return plate.HeightAt(x, y); });
    oracle.Run(ProgramOf(job));
    EXPECT_LT(oracle.Gouge(), 0.012) << side;
    EXPECT_EQ(oracle.rapid_in_stock(), 0) << side;
    EXPECT_LT(oracle.LeftReachable(), 0.05) << side << " at " << oracle.left_at().transpose();
  }
}

TEST(MillProgram, TakesStockOfItsOwn) {
  const Pillars part = PocketPart();
  MillingOptions options = FineOptions("cyl:1.5");
  const Pillars cast{.heights = {{5, 4, 4}, {4, 4, 4}, {4, 4, 5}}, .side = 3};
  auto job = PrepareMilling(part.Mesh(), cast.Mesh(), options);
  ASSERT_TRUE(job.ok()) << job.status();
  const MillProgram program = ProgramOf(*job);
  EXPECT_GT(program.removed_mm3, 60);
  const auto report = ReportOf(*job, program);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->gouges, 0u);
}

/// All divisions into ranges, numbers of threads and orders of triangles give the same bytes.
TEST(MillProgram, DoesNotDependOnRangesThreadsOrTriangles) {
  const TriangleMesh part = PocketPart().Mesh();
  MillingOptions options = OptionsFor("bull:1.5:0.3");
  const MillingJob job = JobOf(part, options);
  const std::string whole = TextOf(job);
  for (const size_t cut : {size_t{1}, size_t{4}, size_t{7}}) {
    std::vector<MilledStep> steps;
    for (size_t first = 0; first < job.steps.size(); first += cut) {
      auto range = MillSteps(job, first, std::min(first + cut, job.steps.size()));
      ASSERT_TRUE(range.ok());
      std::move(range->begin(), range->end(), std::back_inserter(steps));
    }
    const auto program = AssembleProgram(job, steps);
    ASSERT_TRUE(program.ok());
    EXPECT_EQ(ProgramText(*program, options, *DialectOf(MillDialect::kLinuxCnc)), whole) << cut;
  }
  TriangleMesh shuffled = part;
  std::mt19937 random(2);
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  for (auto& t : shuffled.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  EXPECT_EQ(TextOf(JobOf(shuffled, options)), whole);
}

/// A part turned by 90 degrees and mirrored has the same volume cut away. The passes have the same
/// length, except in rest areas, because their rows stay along x.
TEST(MillProgram, TurnsWithThePart) {
  MillingOptions options = OptionsFor("cyl:1.5");
  const TriangleMesh part = PocketPart().Mesh();
  TriangleMesh turned = part, mirrored = part;
  for (Eigen::Vector3d& p : turned.points_mm) p = {-p.y(), p.x(), p.z()};
  for (Eigen::Vector3d& p : mirrored.points_mm) p.x() = -p.x();
  for (auto& t : mirrored.triangles) std::swap(t[0], t[1]);
  const auto report_of = [&](const TriangleMesh& mesh) {
    const MillingJob job = JobOf(mesh, options);
    return *ReportOf(job, ProgramOf(job));
  };
  const MillReport plain = report_of(part);
  for (const TriangleMesh& mesh : {turned, mirrored}) {
    const MillReport other = report_of(mesh);
    EXPECT_EQ(other.gouges, 0u);
    EXPECT_NEAR(other.removed_mm3, plain.removed_mm3, 0.005 * plain.removed_mm3);
    for (const size_t phase : {0, 1})
      EXPECT_NEAR(other.phases[phase].cut_mm, plain.phases[phase].cut_mm,
                  0.03 * plain.phases[phase].cut_mm)
          << phase;
  }
}

TEST(MillProgram, TakesHostileMeshes) {
  TriangleMesh part = PocketPart().Mesh();
  const MillingJob plain_job = JobOf(part, OptionsFor("ball:1.5"));
  const MillProgram plain = ProgramOf(plain_job);
  const size_t count = part.triangles.size();
  for (size_t i = 0; i < count; i += 3) {  // repeated triangles with both orientations, and needles
    const auto t = part.triangles[i];
    part.triangles.push_back(t);
    part.triangles.push_back({t[1], t[0], t[2]});
    part.triangles.push_back({t[0], t[0], t[1]});
  }
  const MillingJob job = JobOf(part, OptionsFor("ball:1.5"));
  const MillProgram program = ProgramOf(job);
  EXPECT_NEAR(program.removed_mm3, plain.removed_mm3, 1e-3 * plain.removed_mm3);
  EXPECT_EQ(ReportOf(job, program)->gouges, 0u);
  MillingOptions open = OptionsFor("ball:1.5");
  open.open_mesh = true;
  part.triangles.resize(count / 2);
  EXPECT_FALSE(TextOf(JobOf(part, open)).empty());
}

TEST(MillProgram, StopsWhenCancelled) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:1.5"));
  const std::vector<MilledStep> steps = AllSteps(job);
  for (int polls = 0; polls < 12; polls += 3) {
    int left = polls;
    const CancelToken cancel([&left] { return left-- <= 0; });
    EXPECT_EQ(AssembleProgram(job, steps, cancel).status().code(), absl::StatusCode::kCancelled);
  }
}

}  // namespace
}  // namespace slicefarm::milling::mill_program_test
