#include "services/texture/algo/map/sparse_cholesky.h"

#include <suitesparse/cholmod.h>

#include <algorithm>

#include "common/base/error.h"
#include "services/texture/algo/map/thread_random.h"

namespace slicefarm::texture {
namespace {

using BlockIndex = SparseCholesky::BlockIndex;

/// Lower triangle of a sparsity pattern, in CHOLMOD's format.
struct Pattern {
  std::vector<int32_t> columns;  ///< start of each column in `rows`
  std::vector<int32_t> rows;     ///< ascending in each column
};

Pattern BlocksAt(int32_t count, std::span<const BlockIndex> indices) {
  std::vector<BlockIndex> lower;  // column and row
  lower.reserve(indices.size() + static_cast<size_t>(count));
  for (const auto& [row, column] : indices)
    lower.emplace_back(std::min(row, column), std::max(row, column));
  for (int32_t i = 0; i < count; ++i) lower.emplace_back(i, i);
  std::sort(lower.begin(), lower.end());
  lower.erase(std::unique(lower.begin(), lower.end()), lower.end());
  Pattern pattern;
  pattern.columns.assign(static_cast<size_t>(count) + 1, 0);
  pattern.rows.reserve(lower.size());
  for (const auto& [column, row] : lower) {
    ++pattern.columns[column + 1];
    pattern.rows.push_back(row);
  }
  for (int32_t i = 0; i < count; ++i) pattern.columns[i + 1] += pattern.columns[i];
  return pattern;
}

/// Expands each entry of a pattern of blocks to a block of entries. Diagonal blocks get only their
/// lower triangle.
Pattern Expanded(const Pattern& blocks, int32_t block) {
  Pattern pattern;
  pattern.columns.push_back(0);
  for (size_t i = 0; i + 1 < blocks.columns.size(); ++i) {
    for (int32_t k = 0; k < block; ++k) {
      const auto column = static_cast<int32_t>(i) * block + k;
      for (int32_t at = blocks.columns[i]; at < blocks.columns[i + 1]; ++at) {
        for (int32_t row = blocks.rows[at] * block; row < (blocks.rows[at] + 1) * block; ++row)
          if (row >= column) pattern.rows.push_back(row);
      }
      pattern.columns.push_back(static_cast<int32_t>(pattern.rows.size()));
    }
  }
  return pattern;
}

class Cholmod {
 public:
  Cholmod() {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.print = 0;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
    common_.postorder = 1;
  }
  ~Cholmod() { cholmod_finish(&common_); }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  /// Returns an order of the blocks for which the factor has few entries.
  std::vector<int32_t> OrderOf(const Pattern& blocks) {
    cholmod_sparse view = ViewOf(blocks);
    std::vector<int32_t> order(view.nrow);
    SeedThreadRandom(1);  // METIS sets the same seed
    if (cholmod_metis(&view, nullptr, 0, 1, order.data(), &common_) == 0)
      for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int32_t>(i);
    return order;
  }

  /// Returns the shape of the factor. Changes `order` to the order of the factor's rows.
  SupernodalShape Analyse(const Pattern& pattern, std::vector<int32_t>* order) {
    cholmod_sparse view = ViewOf(pattern);
    cholmod_factor* factor = cholmod_analyze_p(&view, order->data(), nullptr, 0, &common_);
    const auto copy = [](const void* from, size_t count) {
      const auto* numbers = static_cast<const int32_t*>(from);
      return std::vector<int32_t>(numbers, numbers + count);
    };
    SupernodalShape shape;
    if (factor != nullptr && factor->is_super != 0) {
      *order = copy(factor->Perm, factor->n);
      shape = {.first_column = copy(factor->super, factor->nsuper + 1),
               .first_row = copy(factor->pi, factor->nsuper + 1),
               .rows = copy(factor->s, factor->ssize)};
    }
    cholmod_free_factor(&factor, &common_);
    return shape;
  }

 private:
  static cholmod_sparse ViewOf(const Pattern& pattern) {
    cholmod_sparse view = {};
    view.nrow = view.ncol = pattern.columns.size() - 1;
    view.nzmax = pattern.rows.size();
    view.p = const_cast<int32_t*>(pattern.columns.data());
    view.i = const_cast<int32_t*>(pattern.rows.data());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_PATTERN;
    view.sorted = view.packed = 1;
    return view;
  }

  cholmod_common common_;
};

}  // namespace

SparseCholesky::SparseCholesky(int32_t count, std::span<const BlockIndex> indices, int32_t block) {
  const Pattern blocks = BlocksAt(count, indices);
  Pattern pattern = Expanded(blocks, block);
  Cholmod cholmod;
  for (const int32_t at : cholmod.OrderOf(blocks))
    for (int32_t k = 0; k < block; ++k) order_.push_back(at * block + k);
  SupernodalShape shape = cholmod.Analyse(pattern, &order_);
  columns_ = std::move(pattern.columns);
  rows_ = std::move(pattern.rows);
  values_.assign(rows_.size(), 0);
  if (shape.first_column.empty()) return;  // out of memory; Factor reports it
  factor_.emplace(std::move(shape));
  std::vector<int32_t> row_of(order_.size());
  for (size_t i = 0; i < order_.size(); ++i) row_of[order_[i]] = static_cast<int32_t>(i);
  factor_index_.reserve(rows_.size());
  for (size_t column = 0; column + 1 < columns_.size(); ++column) {
    for (int32_t at = columns_[column]; at < columns_[column + 1]; ++at) {
      const auto [low, high] = std::minmax(row_of[column], row_of[rows_[at]]);
      factor_index_.push_back(factor_->IndexOf(high, low));
    }
  }
}

int32_t SparseCholesky::IndexOf(int32_t row, int32_t column) const {
  if (row < column) std::swap(row, column);
  const auto begin = rows_.begin() + columns_[column], end = rows_.begin() + columns_[column + 1];
  return static_cast<int32_t>(std::lower_bound(begin, end, row) - rows_.begin());
}

absl::Status SparseCholesky::Factor() {
  bool done = false;
  if (factor_) {
    std::vector<double> numbers = factor_->TakeNumbers();
    numbers.assign(static_cast<size_t>(factor_->place_count()), 0);
    for (size_t i = 0; i < values_.size(); ++i) numbers[factor_index_[i]] = values_[i];
    done = factor_->Factor(std::move(numbers));
  }
  if (done) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   "a system of the surface's map is not positive definite");
}

Eigen::VectorXd SparseCholesky::Solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd permuted(right.size());
  for (size_t i = 0; i < order_.size(); ++i)
    permuted[static_cast<Eigen::Index>(i)] = right[order_[i]];
  factor_->Solve(&permuted);
  Eigen::VectorXd result(right.size());
  for (size_t i = 0; i < order_.size(); ++i)
    result[order_[i]] = permuted[static_cast<Eigen::Index>(i)];
  return result;
}

}  // namespace slicefarm::texture
