#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"

namespace slicefarm::infill {

/// Index of segments by the square cells that they pass, to find segments near a point. Cells have
/// the side `cell_nm`. They are larger if the box would have more than four million cells.
class SegmentGrid {
 public:
  /// Creates an empty grid. REQUIRES: cell_nm > 0; all segments are in `box`, which is not empty.
  SegmentGrid(const Box& box, double cell_nm) : origin_(box.min) {
    constexpr double kMostCells = 4e6;
    const auto width = static_cast<double>(box.max.x - box.min.x);
    const auto height = static_cast<double>(box.max.y - box.min.y);
    cell_ = std::max(
        {cell_nm, std::sqrt(width / kMostCells * height), std::max(width, height) / kMostCells});
    columns_ = static_cast<int32_t>(width / cell_) + 1;
    rows_ = static_cast<int32_t>(height / cell_) + 1;
    first_.assign(static_cast<size_t>(columns_) * rows_, -1);
  }

  /// Adds the segment ab; `segment` is its number for ForEachNear.
  void Add(Point a, Point b, int32_t segment) {
    if (a.y > b.y) std::swap(a, b);
    const int32_t top = Row(static_cast<double>(b.y));
    for (int32_t row = Row(static_cast<double>(a.y)); row <= top; ++row) {
      // The range of the segment's x within the row, slightly widened for rounding.
      const double low = std::max(RowStart(row), static_cast<double>(a.y));
      const double high = std::min(RowStart(row + 1), static_cast<double>(b.y));
      const double slope =
          b.y == a.y ? 0 : static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
      double from = static_cast<double>(a.x), to = static_cast<double>(b.x);
      if (b.y != a.y) {
        from = static_cast<double>(a.x) + slope * (low - static_cast<double>(a.y));
        to = static_cast<double>(a.x) + slope * (high - static_cast<double>(a.y));
      }
      if (from > to) std::swap(from, to);
      const int32_t last = Column(to + 1);
      for (int32_t column = Column(from - 1); column <= last; ++column) {
        int32_t& first = first_[static_cast<size_t>(row) * columns_ + column];
        entries_.push_back({segment, first});
        first = static_cast<int32_t>(entries_.size()) - 1;
      }
    }
  }

  /// Calls visit(segment) for all segments that pass within `reach` (in nm) of the bounding box of
  /// a and b. Some segments are visited several times, and some farther segments are visited too.
  template <typename Visit>
  void ForEachNear(Point a, Point b, double reach, Visit visit) const {
    const auto [left, right] = std::minmax(a.x, b.x);
    const auto [low, high] = std::minmax(a.y, b.y);
    const int32_t last_row = Row(static_cast<double>(high) + reach);
    const int32_t last_column = Column(static_cast<double>(right) + reach);
    for (int32_t row = Row(static_cast<double>(low) - reach); row <= last_row; ++row) {
      for (int32_t column = Column(static_cast<double>(left) - reach); column <= last_column;
           ++column) {
        for (int32_t e = first_[static_cast<size_t>(row) * columns_ + column]; e >= 0;
             e = entries_[e].next) {
          visit(entries_[e].segment);
        }
      }
    }
  }

 private:
  struct Entry {
    int32_t segment = 0;
    int32_t next = -1;
  };

  int32_t Place(double from_origin, int32_t count) const {
    return static_cast<int32_t>(
        std::clamp(std::floor(from_origin / cell_), 0.0, static_cast<double>(count - 1)));
  }
  int32_t Row(double y) const { return Place(y - static_cast<double>(origin_.y), rows_); }
  int32_t Column(double x) const { return Place(x - static_cast<double>(origin_.x), columns_); }
  double RowStart(int32_t row) const { return static_cast<double>(origin_.y) + row * cell_; }

  Point origin_;
  double cell_ = 1;
  int32_t columns_ = 1;
  int32_t rows_ = 1;
  std::vector<int32_t> first_;
  std::vector<Entry> entries_;
};

}  // namespace slicefarm::infill
