#include "services/milling/algo/motion/move_builder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::move_builder_test {
namespace {

/// Returns a job with stock of 11 x 10 mm, 4 mm high; the safe height is 9.
MillingJob PocketJob() { return JobOf(PocketPart().Mesh(), OptionsFor("cyl:2")); }

TEST(MoveBuilder, RapidMovesGoOverWhatStands) {
  const MillingJob job = PocketJob();
  MoveBuilder moves(job);
  moves.RapidTo({-4, 4}, 1);
  EXPECT_EQ(moves.at(), Eigen::Vector3d(-4, 4, 1.5));
  moves.RapidTo({15, 4}, 2);
  const std::vector<MillMove> made = moves.TakeMoves();
  const Eigen::Vector3d wanted[] = {
      {-4, 4, 9}, {-4, 4, 1.5}, {-4, 4, 4.5}, {15, 4, 4.5}, {15, 4, 2.5}};
  ASSERT_EQ(made.size(), 5u);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(made[i].kind, MoveKind::kRapid);
    EXPECT_LT((made[i].to_mm - wanted[i]).norm(), 1e-9) << made[i].to_mm.transpose();
  }
}

TEST(MoveBuilder, RapidMovesStayDownWhereAllIsCut) {
  const MillingJob job = PocketJob();
  MoveBuilder moves(job);
  moves.RapidTo({-4, 4}, 2);
  for (double y = 2; y <= 6; y += 0.5) {
    moves.LineTo({moves.at().x(), y, 2}, 100);
    moves.LineTo({moves.at().x() < 0 ? 15.0 : -4.0, y, 2}, 100);
  }
  const double x = moves.at().x();
  moves.RapidTo({4, 4}, 2);
  moves.RapidTo({x, 4}, 2);
  for (const MillMove& move : moves.TakeMoves()) {
    if (move.kind != MoveKind::kRapid || move.to_mm.y() != 4) continue;
    EXPECT_LT(move.to_mm.z(), 9.1);
  }
  EXPECT_NEAR(moves.at().z(), 2.5, 1e-9);
}

/// The slot has a straight side, half a circle and a corner.
TEST(MoveBuilder, FitsArcsWithinTheTolerance) {
  const MillingJob job = PocketJob();
  MoveBuilder moves(job);
  moves.RapidTo({0, 0}, 6);
  std::vector<Eigen::Vector2d> line;
  for (int i = 0; i <= 50; ++i) line.push_back({0.2 * i, 0});
  for (int i = 1; i <= 90; ++i)
    line.push_back({10 + 5 * std::sin(i * std::numbers::pi / 90),
                    5 - 5 * std::cos(i * std::numbers::pi / 90)});
  line.push_back({0, 10});
  moves.FeedAlong(line, 500);
  std::vector<MillMove> made = moves.TakeMoves();
  made.erase(made.begin(), made.begin() + 2);  // removes the moves to the start
  ASSERT_LE(made.size(), 5u);
  size_t arcs = 0;
  Eigen::Vector3d from(0, 0, 6.5);
  for (const MillMove& move : made) {
    for (const Eigen::Vector3d& p : PointsOf(move, from, 1e-4)) {
      double least = 1e9;
      for (size_t i = 0; i + 1 < line.size(); ++i) {
        const Eigen::Vector2d leg = line[i + 1] - line[i];
        const double t = std::clamp((p.head<2>() - line[i]).dot(leg) / leg.squaredNorm(), 0., 1.);
        least = std::min(least, (line[i] + t * leg - p.head<2>()).norm());
      }
      EXPECT_LT(least, job.options.tolerance_mm);
    }
    arcs += move.kind == MoveKind::kCounterClockwise ? 1 : 0;
    from = move.to_mm;
  }
  EXPECT_GE(arcs, 1u);
  EXPECT_EQ(from, Eigen::Vector3d(0, 10, 6.5));
}

}  // namespace
}  // namespace slicefarm::milling::move_builder_test
