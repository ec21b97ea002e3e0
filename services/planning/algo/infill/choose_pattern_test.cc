#include "services/planning/algo/infill/choose_pattern.h"

#include <gtest/gtest.h>

#include "common/model/options/infill_options.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::choose_pattern_test {
namespace {

using enum FillGoal;

struct Case {
  FillGoal goal;
  double density;
  PartShape shape;
  FillPattern want;
};

TEST(ChoosePattern, FollowsItsRules) {
  const PartShape block{40, 40}, flat{3, 40}, wall{40, 3};
  const Case cases[] = {
      {kStrength, 0.2, block, FillPattern::kCubic},
      {kStrength, 0.5, block, FillPattern::kGyroid},
      {kStrength, 0.2, flat, FillPattern::kTriangles},
      {kStrength, 0.2, wall, FillPattern::kGrid},
      {kTime, 0.2, block, FillPattern::kRectilinear},
      {kTime, 0.05, block, FillPattern::kLightning},
      {kTime, 0.2, flat, FillPattern::kRectilinear},
      {kTime, 0.2, wall, FillPattern::kGrid},
      {kFlexibility, 0.2, block, FillPattern::kGyroid},
      {kFlexibility, 0.2, flat, FillPattern::kHoneycomb},
      {kFlexibility, 0.2, wall, FillPattern::kConcentric},
      {kStrength, 0.7, block, FillPattern::kRectilinear},
      {kFlexibility, 0.6, wall, FillPattern::kRectilinear},
      {kStrength, 0, block, FillPattern::kGrid},
  };
  for (const Case& c : cases) {
    const PatternChoice choice = ChoosePattern({.density = c.density, .goal = c.goal}, c.shape);
    EXPECT_EQ(InfoOf(choice.pattern).name, InfoOf(c.want).name)
        << static_cast<int>(c.goal) << " " << c.density << " " << c.shape.height_mm;
    EXPECT_FALSE(choice.reason.empty());
  }
}

TEST(ShapeOf, ACylinderIsAsWideAsItsDiameter) {
  const PartShape square = ShapeOf(Prism(50, "(0 0, 20 0, 20 20, 0 20)"));
  EXPECT_NEAR(square.height_mm, 10, 1e-9);
  EXPECT_NEAR(square.width_mm, 20, 1e-9);
  // The measured width is twice the wall's thickness, less the share of the wall's ends.
  EXPECT_NEAR(ShapeOf(Prism(5, "(0 0, 200 0, 200 2, 0 2)")).width_mm, 4, 0.05);
  EXPECT_EQ(ShapeOf({}).width_mm, 0);
}

}  // namespace
}  // namespace slicefarm::planning::choose_pattern_test
