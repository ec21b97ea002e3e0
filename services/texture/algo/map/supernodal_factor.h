#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "services/texture/algo/map/panel_product.h"

namespace slicefarm::texture {

/// Structure of a factor, independent of its numbers. Supernodes are sequences of columns with
/// entries in the same rows.
struct SupernodalShape {
  /// first column of each supernode; the last entry is the number of columns
  std::vector<int32_t> first_column;
  /// start of each supernode's rows in `rows`; the last entry is the number of `rows`
  std::vector<int32_t> first_row;
  /// rows of the supernodes; ascending in each supernode, beginning with its own columns
  std::vector<int32_t> rows;
};

/// Sparse Cholesky factor: one dense panel per supernode. A panel is computed from all earlier
/// panels that have entries in its columns.
///
/// One thread and a fixed order of sums give the same bits on every machine, independent of its
/// BLAS. Source: Ng and Peyton, "Block sparse Cholesky algorithms on advanced uniprocessor
/// computers", SIAM J. Sci. Comput. 14 (1993), supernodal left-looking algorithm.
class SupernodalFactor {
 public:
  explicit SupernodalFactor(SupernodalShape shape);

  /// Returns the index in `numbers` (the argument of Factor) of an entry. REQUIRES: row >= column,
  /// and the shape contains the entry. Cost: O(log n) for n rows of the supernode.
  int64_t IndexOf(int32_t row, int32_t column) const;
  /// Returns the number of entries of the factor.
  int64_t place_count() const { return first_number_.back(); }

  /// Computes the factor of a matrix. `numbers`: its entries, at the indices of IndexOf; 0
  /// elsewhere. Returns false if the matrix is not positive definite; then there is no factor.
  bool Factor(std::vector<double> numbers);
  /// Returns the memory of the previous factor's numbers, for reuse.
  std::vector<double> TakeNumbers() { return std::move(numbers_); }

  /// Solves the system for `right`, in place. REQUIRES: Factor succeeded.
  void Solve(Eigen::VectorXd* right) const;

 private:
  int32_t count() const { return static_cast<int32_t>(first_number_.size()) - 1; }
  int32_t ColumnsOf(int32_t node) const {
    return shape_.first_column[node + 1] - shape_.first_column[node];
  }
  std::span<const int32_t> RowsOf(int32_t node) const {
    return std::span(shape_.rows)
        .subspan(shape_.first_row[node], shape_.first_row[node + 1] - shape_.first_row[node]);
  }
  /// Adds a finished supernode to the queue of the next panel that needs it. The supernode's rows
  /// before `row` are already used.
  void Queue(int32_t node, int32_t row);
  void SubtractFrom(int32_t node, int32_t earlier);
  bool FactorPanel(int32_t node);
  void SolveDown(int32_t node, double* x, std::vector<double>* sums) const;
  void SolveUp(int32_t node, double* x, std::vector<double>* known) const;

  SupernodalShape shape_;
  /// Index of each supernode's first number in numbers_; the last entry is the size of numbers_.
  std::vector<int64_t> first_number_;
  std::vector<int32_t> node_of_;  ///< supernode of each column
  std::vector<double> numbers_;
  PanelProduct product_;
  // State of the current factorization:
  /// Head of each supernode's queue, linked by next_: the finished supernodes to subtract from its
  /// panel.
  std::vector<int32_t> waiting_;
  std::vector<int32_t> next_;      ///< next supernode in the same queue, per supernode
  std::vector<int32_t> used_;      ///< number of rows already used, per supernode
  std::vector<int32_t> place_of_;  ///< index of each matrix row in the current panel
  /// for each row of the panel that is being subtracted: its index in the current panel
  std::vector<int32_t> places_;
};

}  // namespace slicefarm::texture
