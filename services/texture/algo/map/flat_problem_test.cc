#include "services/texture/algo/map/flat_problem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "services/texture/algo/map/flat_problem_sample_test.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::flat_problem_test {
namespace {

TEST(FlatProblem, AFirstMapIsOneToOneAndAFoldedOneIsNot) {
  FlatProblemSample sample = SampleOf(Cap(8, 0));
  EXPECT_TRUE(sample.problem.IsOneToOne(sample.points));
  EXPECT_TRUE(std::isfinite(sample.problem.TotalEnergy(sample.points)));
  sample.points[40] += Eigen::Vector2d(3, 0);
  EXPECT_FALSE(sample.problem.IsOneToOne(sample.points));
  EXPECT_TRUE(std::isinf(sample.problem.TotalEnergy(sample.points)));
}

TEST(FlatProblem, AStepUpToItsBoundFlipsNothingAndOneBeyondDoes) {
  const FlatProblemSample sample = SampleOf(Cap(8, 0));
  MapPoints direction(sample.points.size(), Eigen::Vector2d::Zero());
  direction[40] = {1, 0.3};
  const double bound = sample.problem.StepBound(sample.points, direction);
  ASSERT_TRUE(std::isfinite(bound));
  EXPECT_TRUE(sample.problem.IsOneToOne(Along(sample, direction, 0.999 * bound)));
  EXPECT_FALSE(sample.problem.IsOneToOne(Along(sample, direction, 1.001 * bound)));
}

TEST(FlatProblem, ReferencesBringNoTriangleFurtherThanTheBound) {
  FlatProblemSample sample = SampleOf(Cap(24, -0.999));
  const double true_energy = sample.problem.TotalEnergy(sample.points);
  ASSERT_FALSE(sample.problem.ApproachReferences(sample.points)) << "the sample is too easy";
  EXPECT_LE(sample.problem.TotalEnergy(sample.points), 250 * sample.problem.area() * 1.1);
  sample.problem.TakeTrueReferences();
  EXPECT_EQ(sample.problem.TotalEnergy(sample.points), true_energy);
}

}  // namespace
}  // namespace slicefarm::texture::flat_problem_test
