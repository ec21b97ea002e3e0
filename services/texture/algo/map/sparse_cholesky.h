#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "services/texture/algo/map/supernodal_factor.h"

namespace slicefarm::texture {

/// A symmetric positive definite system whose pattern stays while its numbers change: ordered and
/// analysed once, factored as often as asked. The same bytes each time.
/// Source: the order is METIS's nested dissection of blocks, the analysis CHOLMOD's, supernodal
/// (Chen, Davis, Hager, Rajamanickam 2008); the numbers are SupernodalFactor's.
class SparseCholesky {
 public:
  /// Row and column of a block.
  using Place = std::pair<int32_t, int32_t>;

  /// `count` blocks of `block` rows and columns. `places`: all blocks in which a number may ever be
  /// other than 0, of either triangle, in any order, repeated as one likes. The diagonal is added.
  SparseCholesky(int32_t count, std::span<const Place> places, int32_t block = 1);

  /// Where an entry's number is in values(). REQUIRES: its block is one of the places. O(log n).
  int32_t IndexOf(int32_t row, int32_t column) const;

  /// The numbers of the lower triangle.
  std::span<double> values() { return values_; }

  /// Errors: INTERNAL if the numbers are not positive definite.
  absl::Status Factor();
  /// REQUIRES: Factor succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

 private:
  // The lower triangle, column by column, rows ascending.
  std::vector<int32_t> columns_;  ///< where each begins in rows_
  std::vector<int32_t> rows_;
  std::vector<double> values_;
  std::vector<int32_t> order_;   ///< by row of the factor: the row of the system
  std::vector<int64_t> places_;  ///< of the values in the factor
  std::optional<SupernodalFactor> factor_;
};

}  // namespace slicefarm::texture
