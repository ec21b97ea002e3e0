#include "services/texture/algo/map/newton_direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "services/texture/algo/map/flat_problem_sample_test.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::newton_direction_test {
namespace {

TEST(NewtonDirection, EachModelGoesDownhillAsItSays) {
  const FlatProblemSample sample = SampleOf(Cap(12, -0.5));
  NewtonDirection newton(sample.problem);
  for (const auto model : {NewtonDirection::Model::kProxy, NewtonDirection::Model::kNewton,
                           NewtonDirection::Model::kConjugate}) {
    const auto path = newton.At(sample.problem, sample.points, model);
    ASSERT_TRUE(path.ok()) << path.status();
    EXPECT_LT(path->slope, 0);
    const double h = 1e-6;
    const double slope = (sample.problem.TotalEnergy(Along(sample, path->direction, h)) -
                          sample.problem.TotalEnergy(Along(sample, path->direction, -h))) /
                         (2 * h);
    EXPECT_NEAR(path->slope, slope, 1e-4 * std::abs(slope));
  }
}

}  // namespace
}  // namespace slicefarm::texture::newton_direction_test
