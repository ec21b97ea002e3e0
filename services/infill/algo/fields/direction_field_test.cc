#include "services/infill/algo/fields/direction_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::infill::direction_field_test {
namespace {

StressField Constant(double xx, double yy, double xy) {
  StressField stress;
  stress.xx.values = {xx}, stress.yy.values = {yy}, stress.xy.values = {xy};
  return stress;
}

/// Returns the angle of a direction in [0, 180).
double DegreesOf(Vector2 direction) {
  const double angle = std::atan2(direction.y(), direction.x()) * 180 / std::numbers::pi;
  return angle < -1e-9 ? angle + 180 : angle;
}

TEST(DirectionField, IsThatOfThePrincipalStressOfGreaterMagnitude) {
  const double cases[][4] = {{0, 1, 0, 90},  {1, 2, 1, 58.28253}, {2, 1, 1, 31.71747},
                             {1, 1, .5, 45}, {1, 1, -.5, 135},    {-3, 1, .2, 177.1447},
                             {1, 0, 0, 0},   {-1, 0, 0, 0},       {0, -2, 1, 112.5},
                             {3, -1, 0, 0},  {1, -3, 0, 90},      {1, -1, 0, 0},
                             {-1, 1, 0, 90}, {-1.005, 1, 0, 90}};
  for (const auto& c : cases) {
    const auto direction = DirectionField(Constant(c[0], c[1], c[2])).At({0, 0, 0});
    ASSERT_TRUE(direction.has_value());
    EXPECT_NEAR(DegreesOf(*direction), c[3], 1e-4);
    EXPECT_NEAR(std::hypot(direction->x(), direction->y()), 1, 1e-12);
  }
}

TEST(DirectionField, HasNoneWhereAllDirectionsAreAlike) {
  for (const double stress : {0.0, 1.0, -4.0})
    EXPECT_FALSE(DirectionField(Constant(stress, stress, 0)).At({0, 0, 0}).has_value());
  EXPECT_TRUE(DirectionField(Constant(1, 1, 0.01)).At({0, 0, 0}).has_value()) << "shear";
}

/// Returns a field with nodes along x at 0, 1, 2, ..., each with a direction in degrees.
StressField Row(const std::vector<double>& degrees, int smoothing) {
  StressField stress;
  stress.smoothing = smoothing;
  for (FieldGrid* grid : {&stress.xx, &stress.yy, &stress.xy}) {
    grid->count = {static_cast<int32_t>(degrees.size()), 1, 1};
    grid->values.clear();
  }
  for (const double angle : degrees) {
    const double t = angle * std::numbers::pi / 180;
    stress.xx.values.push_back(std::cos(t) * std::cos(t));
    stress.yy.values.push_back(std::sin(t) * std::sin(t));
    stress.xy.values.push_back(std::sin(t) * std::cos(t));
  }
  return stress;
}

// Without stress, lines continue in their direction.
TEST(DirectionField, GoesOnWhereThereIsNoStress) {
  StressField stress = Row({30, 30, 30, 30, 30, 70}, 0);
  for (FieldGrid* grid : {&stress.xx, &stress.yy, &stress.xy})
    for (const size_t i : {0, 1, 3, 4}) grid->values[i] = 2;
  stress.xy.values[0] = stress.xy.values[1] = stress.xy.values[3] = stress.xy.values[4] = 0;
  const DirectionField field(stress);
  const double want[] = {30, 30, 30, 30, 70, 70};
  for (int i = 0; i < 6; ++i) {
    const auto direction = field.At({static_cast<double>(i), 0, 0});
    ASSERT_TRUE(direction.has_value()) << i;
    EXPECT_NEAR(DegreesOf(*direction), want[i], 1e-6) << i;
  }
}

// In the middle of circles there is no direction, and the field does not invent one.
TEST(DirectionField, SingularPointsStay) {
  StressField stress;
  for (FieldGrid* grid : {&stress.xx, &stress.yy, &stress.xy}) {
    grid->count = {5, 5, 1};
    grid->values.clear();
  }
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      stress.xx.values.push_back(y * y);
      stress.yy.values.push_back(x * x);
      stress.xy.values.push_back(-x * y);
    }
  }
  const DirectionField field(stress);
  EXPECT_FALSE(field.At({2, 2, 0}).has_value());
  EXPECT_TRUE(field.At({3, 2, 0}).has_value());
}

TEST(DirectionField, OppositeSignsAreNoJump) {
  const DirectionField field(Row({170, 10}, 0));
  const auto middle = field.At({0.5, 0, 0});
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(std::remainder(DegreesOf(*middle), 180), 0, 1e-9);
}

TEST(DirectionField, CrossedDirectionsCancel) {
  const DirectionField field(Row({0, 90}, 0));
  EXPECT_FALSE(field.At({0.5, 0, 0}).has_value());
  EXPECT_TRUE(field.At({0.2, 0, 0}).has_value());
}

TEST(DirectionField, SmoothingTakesNoiseAway) {
  const std::vector<double> noisy = {30, 40, 30, 40, 30, 40, 30, 40};
  const auto spread = [&](int passes) {
    const DirectionField field(Row(noisy, passes));
    return std::abs(DegreesOf(*field.At({3, 0, 0})) - DegreesOf(*field.At({4, 0, 0})));
  };
  EXPECT_NEAR(spread(0), 10, 1e-6);
  EXPECT_LT(spread(1), 0.5);
  const DirectionField straight(Row({25, 25, 25, 25}, 5));
  EXPECT_NEAR(DegreesOf(*straight.At({0.3, 0, 0})), 25, 1e-9);
}

}  // namespace
}  // namespace slicefarm::infill::direction_field_test
