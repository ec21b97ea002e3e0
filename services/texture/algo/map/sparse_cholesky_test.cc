#include "services/texture/algo/map/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::texture::sparse_cholesky_test {
namespace {

/// The system is a random sparse matrix with a heavy diagonal, in both forms.
TEST(SparseCholesky, SolvesAsADenseSolverDoes) {
  std::mt19937 random(1);
  constexpr int kSize = 60;
  std::vector<SparseCholesky::BlockIndex> indices;
  for (int i = 0; i < 200; ++i)
    indices.emplace_back(static_cast<int32_t>(random() % kSize),
                         static_cast<int32_t>(random() % kSize));
  SparseCholesky system(kSize, indices);
  for (int round = 0; round < 3; ++round) {
    std::fill(system.values().begin(), system.values().end(), 0);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kSize, kSize);
    const auto add = [&](int32_t row, int32_t column, double value) {
      system.values()[system.IndexOf(row, column)] += value;
      dense(row, column) += value;
      if (row != column) dense(column, row) += value;
    };
    for (const auto& [row, column] : indices)
      add(row, column, std::uniform_real_distribution(-1.0, 1.0)(random));
    for (int32_t i = 0; i < kSize; ++i) add(i, i, 30);
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(kSize, -1, 3);
    ASSERT_TRUE(system.Factor().ok());
    EXPECT_LE((system.Solve(right) - dense.ldlt().solve(right)).norm(), 1e-12);
  }
}

TEST(SparseCholesky, SaysWhatIsNotPositiveDefiniteAndGoesOn) {
  const std::vector<SparseCholesky::BlockIndex> indices = {{0, 1}};
  SparseCholesky system(2, indices);
  const auto set = [&](double diagonal) {
    system.values()[system.IndexOf(0, 0)] = system.values()[system.IndexOf(1, 1)] = diagonal;
    system.values()[system.IndexOf(1, 0)] = 2;
  };
  set(1);
  EXPECT_EQ(DetailOf(system.Factor()).reason, Reason::kInternal);
  set(4);
  ASSERT_TRUE(system.Factor().ok());
  EXPECT_NEAR((system.Solve(Eigen::Vector2d(8, 10)) - Eigen::Vector2d(1, 2)).norm(), 0, 1e-14);
}

}  // namespace
}  // namespace slicefarm::texture::sparse_cholesky_test
