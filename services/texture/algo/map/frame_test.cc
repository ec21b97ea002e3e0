#include "services/texture/algo/map/frame.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <vector>

namespace slicefarm::texture::frame_test {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

TEST(CrossesItself, TellsSimpleRings) {
  EXPECT_FALSE(CrossesItself(Ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(CrossesItself(Ring{{0, 0}, {1, 1}, {1, 0}, {0, 1}})) << "bow tie";
  EXPECT_TRUE(CrossesItself(Ring{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})) << "touches an edge";
  EXPECT_TRUE(CrossesItself(Ring{{0, 0}, {4, 0}, {2, 0}, {2, 3}})) << "folds back";
  EXPECT_FALSE(CrossesItself(Ring{{0, 0}, {2, 0}, {4, 0}, {2, 3}})) << "a straight corner";
}

/// Returns a square with an additional point pushed in towards the opposite edge.
Ring Dented(double depth) { return {{0, 0}, {4, 0}, {4, 4}, {2, 4 - depth}, {0, 4}}; }

TEST(FrameBarrier, RisesOnlyNearAnEdge) {
  const FrameBarrier barrier(Dented(0));
  EXPECT_EQ(barrier.Energy(Dented(1)), 0);
  double last = 0;
  for (const double depth : {3.8, 3.9, 3.99, 3.999}) {
    EXPECT_GT(barrier.Energy(Dented(depth)), last);
    last = barrier.Energy(Dented(depth));
  }
}

TEST(FrameBarrier, GradientIsTheEnergysAndTheHessianCurvesUpwards) {
  const FrameBarrier barrier(Dented(0));
  const Ring ring = Dented(3.9);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(10);
  for (const FrameBarrier::Term& term : barrier.Terms(ring)) {
    const int32_t corners[] = {term.pair.a, term.pair.b, term.pair.point};
    for (int i = 0; i < 3; ++i)
      gradient.segment<2>(2 * corners[i]) += term.model.gradient.segment<2>(2 * i);
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>;
    EXPECT_GE(Solver(term.model.hessian).eigenvalues().minCoeff(),
              -1e-9 * term.model.hessian.norm());
  }
  EXPECT_GT(gradient.norm(), 1);
  for (int i = 0; i < 10; ++i) {
    Ring more = ring, less = ring;
    more[i / 2][i % 2] += 1e-7;
    less[i / 2][i % 2] -= 1e-7;
    EXPECT_NEAR(gradient[i], (barrier.Energy(more) - barrier.Energy(less)) / 2e-7,
                1e-4 * gradient.norm());
  }
}

}  // namespace
}  // namespace slicefarm::texture::frame_test
