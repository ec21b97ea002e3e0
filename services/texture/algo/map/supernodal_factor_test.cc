#include "services/texture/algo/map/supernodal_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace slicefarm::texture::supernodal_factor_test {
namespace {

/// Returns three supernodes of 2, 1 and 6 columns. The first one has rows in both of the next ones,
/// but not in all of their rows.
SupernodalShape ThreeNodes() {
  return {.first_column = {0, 2, 3, 9},
          .first_row = {0, 5, 8, 14},
          .rows = {0, 1, 2, 4, 7, 2, 4, 7, 3, 4, 5, 6, 7, 8}};
}

/// Returns a positive definite matrix with entries only where the shape has them.
Eigen::MatrixXd MatrixOf(const SupernodalShape& shape, uint32_t seed) {
  std::mt19937 random(seed);
  const int32_t size = shape.first_column.back();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (size_t node = 0; node + 1 < shape.first_column.size(); ++node) {
    for (int32_t column = shape.first_column[node]; column < shape.first_column[node + 1];
         ++column) {
      for (int32_t at = shape.first_row[node]; at < shape.first_row[node + 1]; ++at) {
        const double value = std::uniform_real_distribution(-1.0, 1.0)(random);
        matrix(shape.rows[at], column) = matrix(column, shape.rows[at]) = value;
      }
    }
  }
  matrix.diagonal().array() += size;
  return matrix;
}

std::vector<double> NumbersOf(const Eigen::MatrixXd& matrix, const SupernodalFactor& factor,
                              const SupernodalShape& shape) {
  std::vector<double> numbers(static_cast<size_t>(factor.place_count()), 0.0);
  for (size_t node = 0; node + 1 < shape.first_column.size(); ++node)
    for (int32_t column = shape.first_column[node]; column < shape.first_column[node + 1]; ++column)
      for (int32_t at = shape.first_row[node]; at < shape.first_row[node + 1]; ++at)
        if (shape.rows[at] >= column)
          numbers[factor.IndexOf(shape.rows[at], column)] = matrix(shape.rows[at], column);
  return numbers;
}

/// Returns one supernode of this many columns, with this many rows below that belong to another
/// supernode.
SupernodalShape TwoNodes(int32_t columns, int32_t below) {
  SupernodalShape shape{.first_column = {0, columns, columns + below},
                        .first_row = {0, columns + below, columns + 2 * below},
                        .rows = {}};
  for (int32_t row = 0; row < columns + below; ++row) shape.rows.push_back(row);
  for (int32_t row = 0; row < below; ++row) shape.rows.push_back(columns + row);
  return shape;
}

TEST(SupernodalFactor, SolvesAsADenseSolverDoes) {
  std::vector<SupernodalShape> shapes = {ThreeNodes()};
  for (const int32_t columns : {1, 3, 4, 5, 8, 17, 40})  // strips and blocks, whole and in part
    for (const int32_t below : {1, 2, 7, 30}) shapes.push_back(TwoNodes(columns, below));
  uint32_t seed = 0;
  for (const SupernodalShape& shape : shapes) {
    const Eigen::MatrixXd matrix = MatrixOf(shape, ++seed);
    SupernodalFactor factor(shape);
    ASSERT_TRUE(factor.Factor(NumbersOf(matrix, factor, shape)));
    Eigen::VectorXd solved = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 3);
    const Eigen::VectorXd right = solved;
    factor.Solve(&solved);
    EXPECT_LE((solved - matrix.ldlt().solve(right)).norm(), 1e-13) << seed;
    // The memory of the factor's numbers is reused.
    std::vector<double> numbers = factor.TakeNumbers();
    const Eigen::MatrixXd other = MatrixOf(shape, seed + 1000);
    numbers = NumbersOf(other, factor, shape);
    ASSERT_TRUE(factor.Factor(std::move(numbers)));
    solved = right;
    factor.Solve(&solved);
    EXPECT_LE((solved - other.ldlt().solve(right)).norm(), 1e-13) << seed;
  }
}

TEST(SupernodalFactor, RefusesWhatIsNotPositiveDefinite) {
  const SupernodalShape shape = ThreeNodes();
  for (int32_t at = 0; at < 9; ++at) {
    for (const double bad : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
      Eigen::MatrixXd matrix = MatrixOf(shape, 5);
      matrix(at, at) = bad;
      SupernodalFactor factor(shape);
      EXPECT_FALSE(factor.Factor(NumbersOf(matrix, factor, shape))) << at;
    }
  }
}

}  // namespace
}  // namespace slicefarm::texture::supernodal_factor_test
