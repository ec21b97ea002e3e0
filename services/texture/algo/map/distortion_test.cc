#include "services/texture/algo/map/distortion.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace slicefarm::texture::distortion_test {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

double EnergyAt(const RestTriangle& rest, const Vector6& u) {
  return SymmetricDirichlet(JacobianOf(rest, u.segment<2>(0), u.segment<2>(2), u.segment<2>(4)));
}

Eigen::Matrix2d JacobianAt(const RestTriangle& rest, const Vector6& u) {
  return JacobianOf(rest, u.segment<2>(0), u.segment<2>(2), u.segment<2>(4));
}

/// Returns triangles of many shapes that are not flipped.
Vector6 RandomTriangle(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  for (;;) {
    Vector6 u;
    for (int i = 0; i < 6; ++i) u[i] = number(random);
    const Eigen::Vector2d a = u.segment<2>(2) - u.segment<2>(0),
                          b = u.segment<2>(4) - u.segment<2>(0);
    if (a.x() * b.y() - a.y() * b.x() > 0.05) return u;
  }
}

TEST(SymmetricDirichlet, KnownMaps) {
  const auto energy = [](double a, double b, double c, double d) {
    Eigen::Matrix2d j;
    j << a, b, c, d;
    return SymmetricDirichlet(j);
  };
  EXPECT_DOUBLE_EQ(energy(1, 0, 0, 1), 4);
  EXPECT_DOUBLE_EQ(energy(0, -1, 1, 0), 4);
  EXPECT_DOUBLE_EQ(energy(2, 0, 0, 1), 6.25);
  EXPECT_DOUBLE_EQ(energy(2, 0, 0, 0.5), 8.5);
  EXPECT_DOUBLE_EQ(energy(1, 1, 0, 1), 6);
  EXPECT_TRUE(std::isinf(energy(1, 0, 0, -1))) << "flipped";
  EXPECT_TRUE(std::isinf(energy(1, 2, 2, 4))) << "flat";
}

TEST(RestOf, KeepsTheTrianglesShapeInSpace) {
  const RestTriangle rest = RestOf(Eigen::Vector3d(1, 2, 3), {4, 2, 3}, {1, 2, 5});
  EXPECT_DOUBLE_EQ(rest.area, 3);
  EXPECT_DOUBLE_EQ(SymmetricDirichlet(JacobianOf(rest, {0, 0}, {3, 0}, {0, 2})), 4);
}

TEST(ModelOf, GradientIsTheEnergysByDifferences) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const Vector6 shape = RandomTriangle(random), u = RandomTriangle(random);
    const RestTriangle rest =
        RestOf(Eigen::Vector2d(shape.segment<2>(0)), Eigen::Vector2d(shape.segment<2>(2)),
               Eigen::Vector2d(shape.segment<2>(4)));
    const LocalModel model = ModelOf(JacobianAt(rest, u), rest);
    const LocalModel proxy = ProxyOf(JacobianAt(rest, u), rest);
    for (int i = 0; i < 6; ++i) {
      Vector6 step = Vector6::Zero();
      step[i] = 1e-6;
      const double slope = (EnergyAt(rest, u + step) - EnergyAt(rest, u - step)) / 2e-6;
      EXPECT_NEAR(model.gradient[i], slope, 1e-5 * (1 + model.gradient.norm()));
      EXPECT_NEAR(proxy.gradient[i], slope, 1e-5 * (1 + model.gradient.norm()));
    }
  }
}

/// The expected Hessian is computed by differences of the gradient, with its negative eigenvalues
/// cut.
TEST(ModelOf, HessianIsTheEnergysWithoutItsNegativePart) {
  std::mt19937 random(2);
  int cut = 0;
  for (int round = 0; round < 200; ++round) {
    const Vector6 shape = RandomTriangle(random), u = RandomTriangle(random);
    const RestTriangle rest =
        RestOf(Eigen::Vector2d(shape.segment<2>(0)), Eigen::Vector2d(shape.segment<2>(2)),
               Eigen::Vector2d(shape.segment<2>(4)));
    Eigen::Matrix<double, 6, 6> whole;
    for (int i = 0; i < 6; ++i) {
      Vector6 step = Vector6::Zero();
      step[i] = 1e-6;
      whole.col(i) = (ModelOf(JacobianAt(rest, u + step), rest).gradient -
                      ModelOf(JacobianAt(rest, u - step), rest).gradient) /
                     2e-6;
    }
    const Eigen::Matrix<double, 6, 6> model = ModelOf(JacobianAt(rest, u), rest).hessian;
    const double size = whole.norm();
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>;
    EXPECT_GE(Solver(model).eigenvalues().minCoeff(), -1e-9 * size);
    const Eigen::Matrix<double, 6, 6> missing = model - (whole + whole.transpose()) / 2;
    const Vector6 more = Solver(missing).eigenvalues();
    EXPECT_GE(more.minCoeff(), -1e-5 * size) << "only ever more";
    EXPECT_LE(more.segment<5>(0).cwiseAbs().maxCoeff(), 1e-5 * size) << "in one direction";
    cut += more.maxCoeff() > 1e-4 * size ? 1 : 0;
  }
  EXPECT_GT(cut, 20);
  EXPECT_LT(cut, 180);
}

TEST(ModelOf, ConformalMapsHaveNumbers) {
  const RestTriangle rest = EquilateralRest(1);
  const Eigen::Matrix2d scaled = 0.5 * Eigen::Matrix2d::Identity();
  EXPECT_TRUE(ModelOf(scaled, rest).hessian.allFinite());
  EXPECT_TRUE(ProxyOf(scaled, rest).hessian.allFinite());
}

TEST(NearerRest, CostsAtMostTheBoundAndKeepsWhatIsNear) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const Vector6 shape = RandomTriangle(random), u = RandomTriangle(random);
    const RestTriangle rest =
        RestOf(Eigen::Vector2d(shape.segment<2>(0)), Eigen::Vector2d(shape.segment<2>(2)),
               Eigen::Vector2d(shape.segment<2>(4)));
    const Eigen::Matrix2d jacobian = JacobianAt(rest, u);
    EXPECT_LE(EnergyAt(NearerRest(rest, jacobian, 10), u), 10 * (1 + 1e-9));
    const double loose = 2 * EnergyAt(rest, u);
    EXPECT_NEAR(EnergyAt(NearerRest(rest, jacobian, loose), u), EnergyAt(rest, u), 1e-9 * loose);
  }
}

}  // namespace
}  // namespace slicefarm::texture::distortion_test
