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

/// Symmetric positive definite system. The positions of its entries are fixed, its numbers may
/// change. The positions are ordered and analysed once; then the system may be factored often. The
/// results are always the same, bit by bit.
///
/// Sources: the order is METIS's nested dissection of blocks. The supernodal analysis is CHOLMOD's
/// (Chen, Davis, Hager, Rajamanickam 2008). SupernodalFactor computes the numbers.
class SparseCholesky {
 public:
  /// Row and column of a block.
  using BlockIndex = std::pair<int32_t, int32_t>;

  /// Builds a system of `count` x `count` blocks; a block has `block` rows and columns. `indices`:
  /// rows and columns of all blocks that may ever contain a number other than 0, of either
  /// triangle, in any order; repetitions are allowed. Diagonal blocks are added.
  SparseCholesky(int32_t count, std::span<const BlockIndex> indices, int32_t block = 1);

  /// Returns the index of an entry in values(). REQUIRES: the entry's block is in `indices` of the
  /// constructor. Cost: O(log n) for n entries of the column.
  int32_t IndexOf(int32_t row, int32_t column) const;

  /// Returns the entries of the lower triangle, to be set before Factor.
  std::span<double> values() { return values_; }

  /// Factors the system. Errors: INTERNAL if the numbers are not positive definite.
  absl::Status Factor();
  /// Solves the system for a right-hand side. REQUIRES: Factor succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

 private:
  // Pattern and numbers of the lower triangle, column by column, with ascending rows.
  std::vector<int32_t> columns_;  ///< start of each column in rows_
  std::vector<int32_t> rows_;
  std::vector<double> values_;
  std::vector<int32_t> order_;         ///< row of the system for each row of the factor
  std::vector<int64_t> factor_index_;  ///< index in the factor of each entry of values()
  std::optional<SupernodalFactor> factor_;
};

}  // namespace slicefarm::texture
