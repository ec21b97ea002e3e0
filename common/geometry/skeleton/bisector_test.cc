#include "common/geometry/skeleton/bisector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace slicefarm::bisector_test {
namespace {

constexpr double kErrorNm = 1e-6;

/// A line or a point; a line if `normal` is not zero.
struct Part {
  Vector2 normal = Vector2::Zero();
  double offset = 0;
  Vector2 point = Vector2::Zero();

  bool IsLine() const { return Norm(normal) > 0; }
  SidedLine Line() const { return {normal, offset}; }
  double DistanceTo(const Vector2& p) const {
    return IsLine() ? Line().DistanceTo(p) : Norm(p - point);
  }
};

Part LineAt(double degrees, double offset) {
  const double angle = degrees / 180 * std::numbers::pi;
  return {{std::cos(angle), std::sin(angle)}, offset, Vector2::Zero()};
}
Part PointAt(double x, double y) { return {Vector2::Zero(), 0, {x, y}}; }

std::optional<Bisector> Between(const Part& left, const Part& right) {
  if (left.IsLine() && right.IsLine()) return Bisector::OfLines(left.Line(), right.Line());
  if (left.IsLine()) return Bisector::OfLineAndPoint(left.Line(), right.point);
  if (right.IsLine()) return Bisector::OfPointAndLine(left.point, right.Line());
  return Bisector::OfPoints(left.point, right.point);
}

struct PairCase {
  std::string name;
  Part left, right;
};

// The region's side of a line is where its distance is positive. The line at 90 degrees has the
// region above it, and is on the right of a walk to the right.
std::vector<PairCase> Pairs() {
  return {
      {"ParallelLines", LineAt(-90, 2'000), LineAt(90, 3'000)},
      {"Wedge", LineAt(-80, 2'000), LineAt(85, 3'000)},
      {"NearlyParallelLines", LineAt(-90.0001, 2'000), LineAt(90, 3'000)},
      {"NeighboursOfABluntCorner", LineAt(89, 0), LineAt(91, 0)},
      {"PointOverLine", PointAt(100, 4'000), LineAt(90, 3'000)},
      {"LineOverPoint", LineAt(-90, 2'000), PointAt(-500, -3'000)},
      {"TwoPoints", PointAt(0, 1'000), PointAt(300, -1'000)},
  };
}

class BisectorPair : public testing::TestWithParam<PairCase> {
 protected:
  const Part& left_ = GetParam().left;
  const Part& right_ = GetParam().right;
  const std::optional<Bisector> curve_ = Between(left_, right_);
};

TEST_P(BisectorPair, HasEqualDistances) {
  ASSERT_TRUE(curve_.has_value());
  for (const double t : {-700.0, 0.0, 1.0, 900.0}) {
    const Disc disc = curve_->At(t);
    EXPECT_NEAR(left_.DistanceTo(disc.centre), disc.radius, kErrorNm) << t;
    EXPECT_NEAR(right_.DistanceTo(disc.centre), disc.radius, kErrorNm) << t;
    EXPECT_NEAR(curve_->ParameterOf(disc.centre), t, kErrorNm);
  }
}

TEST_P(BisectorPair, GrowsWithTheFirstFeatureOnTheLeft) {
  ASSERT_TRUE(curve_.has_value());
  const double t = 700;
  const Vector2 at = curve_->At(t).centre, ahead = curve_->At(t + 1).centre - at;
  const auto contact = [&](const Part& part) -> Vector2 {
    if (part.IsLine()) return -part.DistanceTo(at) * part.normal;
    return part.point - at;
  };
  EXPECT_GT(Cross(ahead, contact(left_)), 0);
  EXPECT_LT(Cross(ahead, contact(right_)), 0);
}

TEST_P(BisectorPair, TouchesWhatItsDiscsTouch) {
  ASSERT_TRUE(curve_.has_value());
  const double t = 400;
  const Disc disc = curve_->At(t);
  for (const double degrees : {-175.0, -20.0, 10.0, 160.0}) {
    const double angle = degrees / 180 * std::numbers::pi;
    const Vector2 away = {std::cos(angle), std::sin(angle)};
    const Vector2 contact = disc.centre + disc.radius * away;
    const auto finds = [&](const Roots& roots) {
      for (const double root : roots)
        if (std::abs(root - t) < 1e-3) return true;
      return false;
    };
    EXPECT_TRUE(finds(curve_->Touching(contact))) << degrees;
    EXPECT_TRUE(finds(curve_->Touching(SidedLine{-away, Dot(away, contact)}))) << degrees;
    EXPECT_TRUE(finds(curve_->Crossing({away, -Dot(away, disc.centre)}))) << degrees;
  }
}

TEST_P(BisectorPair, EveryRootTouches) {
  ASSERT_TRUE(curve_.has_value());
  int roots = 0;
  for (const Vector2& point : {Vector2(500, 100), Vector2(-4'000, 0), Vector2(90, 2'500)}) {
    for (const double t : curve_->Touching(point)) {
      const Disc disc = curve_->At(t);
      EXPECT_NEAR(Norm(point - disc.centre), std::abs(disc.radius), 1e-4);
      ++roots;
    }
  }
  for (const Part& part : {LineAt(180, 5'000), LineAt(0, 7'000), LineAt(45, 4'000)}) {
    for (const double t : curve_->Touching(part.Line())) {
      const Disc disc = curve_->At(t);
      EXPECT_NEAR(part.DistanceTo(disc.centre), disc.radius, 1e-4);
      ++roots;
    }
  }
  EXPECT_GT(roots, 0);
}

INSTANTIATE_TEST_SUITE_P(Bisector, BisectorPair, testing::ValuesIn(Pairs()),
                         [](const auto& info) { return info.param.name; });

TEST(Bisector, IsRefusedForFeaturesAtOnePlace) {
  EXPECT_FALSE(Bisector::OfPoints({5, 5}, {5, 5.5}).has_value());
  EXPECT_FALSE(Bisector::OfLineAndPoint(LineAt(90, 0).Line(), {700, 0.5}).has_value());
  EXPECT_FALSE(Bisector::OfPointAndLine({700, -1}, LineAt(90, 0).Line()).has_value());
  EXPECT_FALSE(Bisector::OfLines(LineAt(90, 0).Line(), LineAt(90, 1).Line()).has_value());
}

TEST(Bisector, HasNoTouchingDiscBeyondReach) {
  // Between two parallel lines, no disc reaches a point beyond one of them.
  const auto strip = Bisector::OfLines(LineAt(-90, 1'000).Line(), LineAt(90, 1'000).Line());
  ASSERT_TRUE(strip.has_value());
  EXPECT_EQ(strip->Touching(Vector2(0, 3'000)).count, 0);
  EXPECT_EQ(strip->Touching(Vector2(0, 0)).count, 2);
  EXPECT_EQ(strip->Touching(LineAt(90, 4'000).Line()).count, 0);
}

}  // namespace
}  // namespace slicefarm::bisector_test
