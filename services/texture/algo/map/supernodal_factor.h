#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "services/texture/algo/map/panel_product.h"

namespace slicefarm::texture {

/// What a factor looks like, whatever its numbers: supernodes are runs of columns that have entries
/// in the same rows.
struct SupernodalShape {
  std::vector<int32_t> first_column;  ///< by supernode, and the number of columns
  std::vector<int32_t> first_row;     ///< where its rows begin in `rows`, and their number
  std::vector<int32_t> rows;          ///< ascending in each supernode; its columns come first
};

/// A sparse Cholesky factor: dense panels, one for each supernode, each made of those before it
/// that have entries in its columns.
///
/// One thread and one order of sums: the same bytes on every machine, whatever BLAS it has.
/// Source: Ng and Peyton, "Block sparse Cholesky algorithms on advanced uniprocessor computers",
/// SIAM J. Sci. Comput. 14 (1993), the supernodal left-looking one.
class SupernodalFactor {
 public:
  explicit SupernodalFactor(SupernodalShape shape);

  /// Where an entry's number is in Factor's `numbers`. REQUIRES: row >= column, and the shape has
  /// it. O(log n).
  int64_t PlaceOf(int32_t row, int32_t column) const;
  int64_t place_count() const { return first_number_.back(); }

  /// Makes the factor of the matrix whose numbers are at their places, and 0 at all others.
  /// False: it is not positive definite, and there is no factor.
  bool Factor(std::vector<double> numbers);
  /// The numbers of the factor before, to be used again.
  std::vector<double> TakeNumbers() { return std::move(numbers_); }

  /// REQUIRES: Factor succeeded.
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
  /// Puts a finished supernode, whose rows before `row` were used, where it is needed next.
  void Queue(int32_t node, int32_t row);
  void SubtractFrom(int32_t node, int32_t earlier);
  bool FactorPanel(int32_t node);
  void SolveDown(int32_t node, double* x, std::vector<double>* sums) const;
  void SolveUp(int32_t node, double* x, std::vector<double>* known) const;

  SupernodalShape shape_;
  std::vector<int64_t> first_number_;  ///< by supernode, and their number
  std::vector<int32_t> node_of_;       ///< by column
  std::vector<double> numbers_;
  PanelProduct product_;
  // Of the factorization that is going on:
  std::vector<int32_t> waiting_;   ///< by supernode: the first of those that have a part in it
  std::vector<int32_t> next_;      ///< by supernode: the next one that waits with it
  std::vector<int32_t> used_;      ///< by supernode: rows that were used
  std::vector<int32_t> place_of_;  ///< by row of the matrix: in the panel that is made
  std::vector<int32_t> places_;    ///< by row of the earlier panel
};

}  // namespace slicefarm::texture
