#include "services/motion/algo/toolpath/printed_heights.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

/// Least side of a square, and largest number of squares in the tip's radius.
constexpr Coord kLeastSquareNm = 200'000;
constexpr Coord kSquaresInTip = 3;

uint64_t KeyOf(Coord column, Coord row) {
  return static_cast<uint64_t>(column) << 32 ^ (static_cast<uint64_t>(row) & 0xffffffff);
}

}  // namespace

PrintedHeights::PrintedHeights(Coord tip_nm)
    : tip_nm_(tip_nm), side_nm_(std::max(kLeastSquareNm, tip_nm / kSquaresInTip)) {}

Coord PrintedHeights::IndexOf(Coord nm) const {
  return nm >= 0 ? nm / side_nm_ : -((-nm - 1) / side_nm_) - 1;
}

Point PrintedHeights::MiddleOf(Coord column, Coord row) const {
  return {column * side_nm_ + side_nm_ / 2, row * side_nm_ + side_nm_ / 2};
}

void PrintedHeights::Add(Point point, Coord up_nm) {
  const auto [square, is_new] =
      up_nm_.try_emplace(KeyOf(IndexOf(point.x), IndexOf(point.y)), up_nm);
  if (!is_new) square->second = std::max(square->second, up_nm);
}

Coord PrintedHeights::LeastUp(Point point, Coord lowest_nm) const {
  Coord least = lowest_nm;
  if (up_nm_.empty()) return least;
  const Coord reach = tip_nm_ - lowest_nm;
  for (Coord row = IndexOf(point.y - reach); row <= IndexOf(point.y + reach); ++row) {
    for (Coord column = IndexOf(point.x - reach); column <= IndexOf(point.x + reach); ++column) {
      const auto square = up_nm_.find(KeyOf(column, row));
      if (square == up_nm_.end() || square->second <= least) continue;
      const double beyond =
          std::max(0.0, Distance(point, MiddleOf(column, row)) - static_cast<double>(tip_nm_));
      least = std::max(least, square->second - static_cast<Coord>(beyond));
    }
  }
  return least;
}

}  // namespace slicefarm::motion
