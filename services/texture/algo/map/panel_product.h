#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slicefarm::texture {

/// Dense block in a matrix that is stored column by column: a view.
struct Panel {
  const double* numbers = nullptr;
  ptrdiff_t stride = 0;  ///< number of doubles from one column to the next
  int32_t rows = 0;
  int32_t columns = 0;
};

/// Computes the scalar products of a panel's rows with its own first rows: the main operation of a
/// Cholesky factorization. Each sum adds the columns in their order, so its last bit depends on
/// nothing else.
class PanelProduct {
 public:
  /// Calls store(i, k, sum) for all rows i and k of the panel with k < tops and k <= i. `sum` is
  /// the scalar product of rows i and k. `store` may also be called for some k > i. Cost: about 3
  /// multiply-adds per cycle for a large panel.
  template <typename Store>
  void Multiply(const Panel& panel, int32_t tops, const Store& store) {
    Pack(panel, tops, &tops_);
    for (int32_t i = 0; i < panel.rows; i += kStrip) {
      const int32_t last = std::min(i + kStrip, panel.rows) - 1;
      const double* rows = tops_.data() + ptrdiff_t{i} * panel.columns;
      if (i >= tops) {
        PackStrip(panel, i, last + 1, strip_.data());
        rows = strip_.data();
      }
      for (int32_t k = 0; k < tops && k <= last; k += kStrip) {
        const Block block =
            BlockOf(rows, tops_.data() + ptrdiff_t{k} * panel.columns, panel.columns);
        for (int32_t column = k; column < std::min(k + kStrip, tops); ++column)
          for (int32_t row = i; row <= last; ++row)
            store(row, column, block[kStrip * (column - k) + row - i]);
      }
    }
  }

 private:
  static constexpr int32_t kStrip = 4;
  /// Pair of numbers that every x86-64 processor handles in one instruction.
  using Two = double __attribute__((vector_size(16)));
  using Block = std::array<double, kStrip * kStrip>;  ///< stored column by column

  /// Copies strips of four rows, each one column by column.
  void Pack(const Panel& panel, int32_t rows, std::vector<double>* packed) {
    const int32_t strips = (rows + kStrip - 1) / kStrip;
    strip_.resize(static_cast<size_t>(kStrip) * panel.columns);
    packed->resize(static_cast<size_t>(strips) * kStrip * panel.columns);
    for (int32_t i = 0; i < rows; i += kStrip) {
      // The last strip also contains the rows below it, as every other strip does.
      PackStrip(panel, i, std::min(i + kStrip, panel.rows),
                packed->data() + ptrdiff_t{i} * panel.columns);
    }
  }

  static void PackStrip(const Panel& panel, int32_t from, int32_t to, double* packed) {
    const double* numbers = panel.numbers + from;
    for (int32_t column = 0; column < panel.columns; ++column, numbers += panel.stride) {
      for (int32_t i = 0; i < kStrip; ++i) *packed++ = from + i < to ? numbers[i] : 0;
    }
  }

  static Block BlockOf(const double* rows, const double* tops, int32_t columns) {
    Two a0 = {}, a1 = {}, b0 = {}, b1 = {}, c0 = {}, c1 = {}, d0 = {}, d1 = {};
    for (int32_t i = 0; i < columns; ++i, rows += kStrip, tops += kStrip) {
      const Two low = {rows[0], rows[1]}, high = {rows[2], rows[3]};
      a0 += low * tops[0];
      a1 += high * tops[0];
      b0 += low * tops[1];
      b1 += high * tops[1];
      c0 += low * tops[2];
      c1 += high * tops[2];
      d0 += low * tops[3];
      d1 += high * tops[3];
    }
    return {a0[0], a0[1], a1[0], a1[1], b0[0], b0[1], b1[0], b1[1],
            c0[0], c0[1], c1[0], c1[1], d0[0], d0[1], d1[0], d1[1]};
  }

  std::vector<double> tops_, strip_;
};

}  // namespace slicefarm::texture
