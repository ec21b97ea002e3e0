#include "services/texture/algo/map/supernodal_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace slicefarm::texture {
namespace {

constexpr int32_t kNone = -1;
constexpr int32_t kColumnsAtOnce = 8;  // columns of a panel that are factored one by one
constexpr int32_t kSumsAtOnce = 4;     // independent sums at the same time

using Numbers = Eigen::Map<Eigen::VectorXd>;
using ConstNumbers = Eigen::Map<const Eigen::VectorXd>;

/// Factors the columns [from, to) of a panel. REQUIRES: the contributions of all columns before
/// `from` are subtracted. Returns false if the matrix is not positive definite.
bool FactorColumns(double* panel, int32_t rows, int32_t from, int32_t to) {
  for (int32_t k = from; k < to; ++k) {
    double* column = panel + ptrdiff_t{k} * rows;
    if (!(column[k] > 0)) return false;
    const double root = std::sqrt(column[k]), inverse = 1 / root;
    if (!std::isfinite(inverse)) return false;
    column[k] = root;
    Numbers(column + k + 1, rows - k - 1) *= inverse;
    for (int32_t other = k + 1; other < to; ++other) {
      Numbers(panel + ptrdiff_t{other} * rows + other, rows - other) -=
          column[other] * ConstNumbers(column + other, rows - other);
    }
  }
  return true;
}

}  // namespace

SupernodalFactor::SupernodalFactor(SupernodalShape shape) : shape_(std::move(shape)) {
  const auto nodes = shape_.first_column.size() - 1;
  const auto columns = static_cast<size_t>(shape_.first_column.back());
  first_number_.push_back(0);
  node_of_.resize(columns);
  for (int32_t node = 0; node < static_cast<int32_t>(nodes); ++node) {
    const auto rows = static_cast<int64_t>(RowsOf(node).size());
    first_number_.push_back(first_number_.back() + rows * ColumnsOf(node));
    std::fill(node_of_.begin() + shape_.first_column[node],
              node_of_.begin() + shape_.first_column[node + 1], node);
  }
  waiting_.resize(nodes);
  next_.resize(nodes);
  used_.resize(nodes);
  place_of_.resize(columns);
}

int64_t SupernodalFactor::IndexOf(int32_t row, int32_t column) const {
  const int32_t node = node_of_[column];
  const auto rows = RowsOf(node);
  const auto at = std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
  const int64_t before = column - shape_.first_column[node];
  return first_number_[node] + before * static_cast<int64_t>(rows.size()) + at;
}

void SupernodalFactor::Queue(int32_t node, int32_t row) {
  used_[node] = row;
  const auto rows = RowsOf(node);
  if (row == static_cast<int32_t>(rows.size())) return;
  const int32_t by = node_of_[rows[row]];
  next_[node] = std::exchange(waiting_[by], node);
}

void SupernodalFactor::SubtractFrom(int32_t node, int32_t earlier) {
  const auto all = RowsOf(earlier);
  const auto rows = all.subspan(used_[earlier]);
  const int32_t end = shape_.first_column[node + 1];
  const auto tops =
      static_cast<int32_t>(std::lower_bound(rows.begin(), rows.end(), end) - rows.begin());
  places_.clear();
  for (const int32_t row : rows) places_.push_back(place_of_[row]);
  double* panel = numbers_.data() + first_number_[node];
  const auto stride = static_cast<ptrdiff_t>(RowsOf(node).size());
  product_.Multiply({.numbers = numbers_.data() + first_number_[earlier] + used_[earlier],
                     .stride = static_cast<ptrdiff_t>(all.size()),
                     .rows = static_cast<int32_t>(rows.size()),
                     .columns = ColumnsOf(earlier)},
                    tops, [&](int32_t i, int32_t k, double sum) {
                      if (i >= k) panel[places_[k] * stride + places_[i]] -= sum;
                    });
  Queue(earlier, used_[earlier] + tops);
}

bool SupernodalFactor::FactorPanel(int32_t node) {
  double* panel = numbers_.data() + first_number_[node];
  const auto rows = static_cast<int32_t>(RowsOf(node).size()), columns = ColumnsOf(node);
  for (int32_t from = 0; from < columns; from += kColumnsAtOnce) {
    const int32_t to = std::min(from + kColumnsAtOnce, columns);
    if (from > 0) {
      product_.Multiply(
          {.numbers = panel + from, .stride = rows, .rows = rows - from, .columns = from},
          to - from, [&](int32_t i, int32_t k, double sum) {
            if (i >= k) panel[ptrdiff_t{from + k} * rows + from + i] -= sum;
          });
    }
    if (!FactorColumns(panel, rows, from, to)) return false;
  }
  return true;
}

bool SupernodalFactor::Factor(std::vector<double> numbers) {
  numbers_ = std::move(numbers);
  std::fill(waiting_.begin(), waiting_.end(), kNone);
  for (int32_t node = 0; node < count(); ++node) {
    const auto rows = RowsOf(node);
    for (size_t i = 0; i < rows.size(); ++i) place_of_[rows[i]] = static_cast<int32_t>(i);
    for (int32_t earlier = waiting_[node]; earlier != kNone;) {
      const int32_t next = next_[earlier];
      SubtractFrom(node, earlier);
      earlier = next;
    }
    if (!FactorPanel(node)) return false;
    Queue(node, ColumnsOf(node));
  }
  return true;
}

/// Solves L y = b for the columns of one supernode, and updates the sums for the rows below.
void SupernodalFactor::SolveDown(int32_t node, double* x, std::vector<double>* sums) const {
  const auto rows = RowsOf(node);
  const auto height = static_cast<int32_t>(rows.size()), columns = ColumnsOf(node);
  const double* column = numbers_.data() + first_number_[node];
  double* own = x + shape_.first_column[node];
  sums->assign(rows.size(), 0);
  for (int32_t k = 0; k < columns; ++k, column += height) {
    own[k] = (own[k] - (*sums)[k]) / column[k];
    Numbers(sums->data() + k + 1, height - k - 1) +=
        own[k] * ConstNumbers(column + k + 1, height - k - 1);
  }
  for (int32_t i = columns; i < height; ++i) x[rows[i]] -= (*sums)[i];
}

/// Solves L^T x = y for the columns of one supernode.
void SupernodalFactor::SolveUp(int32_t node, double* x, std::vector<double>* known) const {
  const auto rows = RowsOf(node);
  const auto height = static_cast<int32_t>(rows.size()), columns = ColumnsOf(node);
  const double* panel = numbers_.data() + first_number_[node];
  double* own = x + shape_.first_column[node];
  known->resize(rows.size());
  for (int32_t i = 0; i < height; ++i) (*known)[i] = x[rows[i]];
  for (int32_t end = columns; end > 0; end -= kSumsAtOnce) {
    const int32_t begin = std::max(0, end - kSumsAtOnce);
    std::array<double, kSumsAtOnce> sums = {};
    std::array<const double*, kSumsAtOnce> column;
    for (int32_t k = 0; k < kSumsAtOnce; ++k)
      column[k] = panel + ptrdiff_t{std::min(begin + k, end - 1)} * height;
    for (int32_t i = end; i < height; ++i)
      for (int32_t k = 0; k < kSumsAtOnce; ++k) sums[k] += column[k][i] * (*known)[i];
    for (int32_t k = end; k-- > begin;) {
      double sum = own[k] - sums[k - begin];
      for (int32_t i = k + 1; i < end; ++i) sum -= column[k - begin][i] * (*known)[i];
      own[k] = (*known)[k] = sum / column[k - begin][k];
    }
  }
}

void SupernodalFactor::Solve(Eigen::VectorXd* right) const {
  std::vector<double> numbers;
  for (int32_t node = 0; node < count(); ++node) SolveDown(node, right->data(), &numbers);
  for (int32_t node = count(); node-- > 0;) SolveUp(node, right->data(), &numbers);
}

}  // namespace slicefarm::texture
