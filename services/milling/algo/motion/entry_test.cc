#include "services/milling/algo/motion/entry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "services/milling/algo/sample_jobs_test.h"
#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling::entry_test {
namespace {

ClosedPath SquarePath(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

PolygonWithHoles SquareArea(double low, double high) {
  PolygonWithHoles area;
  for (const Eigen::Vector2d& p : SquarePath(low, high)) area.outer.push_back(PointOf(p));
  return area;
}

/// Returns the greatest slope of moves that go down.
double SteepestOf(const std::vector<MillMove>& moves) {
  double steepest = 0;
  for (size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].kind == MoveKind::kRapid) continue;
    const double fall = moves[i - 1].to_mm.z() - moves[i].to_mm.z();
    const double length = LengthOf(moves[i], moves[i - 1].to_mm);
    steepest = std::max(steepest, fall / std::sqrt(length * length - fall * fall));
  }
  return steepest;
}

TEST(RampDown, GoesRoundAtTheAngle) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:2"));
  const double slope = std::tan(job.options.machining.ramp_angle_deg * std::numbers::pi / 180);
  for (const double z : {3.9, 3.0, 0.5}) {
    MoveBuilder moves(job);
    moves.RapidTo({3, 3}, 4);
    const double from = moves.at().z();
    const ClosedPath rest = RampDown(SquarePath(3, 5), z, job.options, moves);
    EXPECT_NEAR(moves.at().z(), z, 1e-9);
    EXPECT_LT((rest.front() - moves.at().head<2>()).norm(), 1e-3);
    double length = 0;
    for (size_t i = 0; i < rest.size(); ++i)
      length += (rest[(i + 1) % rest.size()] - rest[i]).norm();
    EXPECT_NEAR(length, 8, 1e-9);  // the whole pass remains to be cut
    const auto made = moves.TakeMoves();
    EXPECT_NEAR(SteepestOf(made), slope, 0.02 * slope + 1e-3) << from - z;
  }
}

TEST(HelixDown, FitsOrTellsThatItDoesNot) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:2"));
  const double slope = std::tan(job.options.machining.ramp_angle_deg * std::numbers::pi / 180);
  MoveBuilder moves(job);
  moves.RapidTo({3, 3}, 4);
  EXPECT_FALSE(HelixDown(SquarePath(3, 3.5), SquareArea(3, 3.5), 2, job.options, moves));
  ASSERT_TRUE(HelixDown(SquarePath(3, 5), SquareArea(2, 6), 2, job.options, moves));
  EXPECT_EQ(moves.at(), Eigen::Vector3d(3, 3, 2));
  const auto made = moves.TakeMoves();
  EXPECT_LE(SteepestOf(made), slope * 1.01);
  for (const MillMove& move : made) {
    if (move.kind == MoveKind::kRapid) continue;
    EXPECT_LT((move.centre_mm - Eigen::Vector2d(3, 3.5)).norm(), 1e-9);
  }
}

TEST(LeadArcsOf, LieOnTheFreeSideAndTouchTheWay) {
  const ClosedPath pass = {{2, 2}, {8, 2}, {8, 8}, {2, 8}};  // the free side is inside
  const PolygonWithHoles area = SquareArea(2, 8);
  const ClosedPath middle = {{5, 2}, {8, 2}, {8, 8}, {2, 8}, {2, 2}};
  EXPECT_FALSE(LeadArcsOf(pass, area, 1, CutDirection::kClimb).has_value());  // in the corner
  const auto arcs = LeadArcsOf(middle, area, 1, CutDirection::kClimb);
  ASSERT_TRUE(arcs.has_value());
  EXPECT_LT((arcs->from - Eigen::Vector2d(4, 3)).norm(), 1e-9);
  EXPECT_LT((arcs->to - Eigen::Vector2d(6, 3)).norm(), 1e-9);
  EXPECT_FALSE(arcs->clockwise);
  EXPECT_FALSE(LeadArcsOf(middle, area, 1, CutDirection::kConventional).has_value());
  EXPECT_FALSE(LeadArcsOf(middle, area, 0, CutDirection::kClimb).has_value());
}

}  // namespace
}  // namespace slicefarm::milling::entry_test
