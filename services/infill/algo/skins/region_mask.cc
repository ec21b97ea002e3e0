#include "services/infill/algo/skins/region_mask.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::infill {
namespace {

constexpr double kMaskSquareNm = 400'000;
constexpr int32_t kMostMaskSquares = 512;  ///< limit for a row or column
/// Additional thickness of edges, in squares, for rounding.
constexpr double kSlack = 1e-3;

uint64_t BitsFrom(int32_t column) { return ~uint64_t{0} << (column % 64); }
uint64_t BitsTo(int32_t column) { return ~uint64_t{0} >> (63 - column % 64); }

}  // namespace

RegionMask::RegionMask(const MultiPolygon& region) : box_(Bounds(region)) {
  if (box_.Empty()) return;
  const auto width = static_cast<double>(box_.max.x - box_.min.x);
  const auto height = static_cast<double>(box_.max.y - box_.min.y);
  squares_per_nm_ = 1 / std::max(kMaskSquareNm, std::max(width, height) / (kMostMaskSquares - 2));
  columns_ = static_cast<int32_t>(width * squares_per_nm_) + 1;
  rows_ = static_cast<int32_t>(height * squares_per_nm_) + 1;
  words_ = (columns_ + 63) / 64;
  bits_.assign(static_cast<size_t>(rows_) * words_, 0);
  ForEachRing(region, [this](const Polygon& ring) { MarkBoundary(ring); });
  MarkInside(region);
}

bool RegionMask::MayMeet(const MultiPolygon& outlines) const {
  return std::any_of(outlines.begin(), outlines.end(), [this](const PolygonWithHoles& island) {
    return RingMeets(island.outer) ||
           std::any_of(island.holes.begin(), island.holes.end(),
                       [this](const Polygon& hole) { return RingMeets(hole); });
  });
}

template <typename Visit>
bool RegionMask::ForEachSpan(Point a, Point b, Visit visit) const {
  double ax = static_cast<double>(a.x - box_.min.x) * squares_per_nm_;
  double ay = static_cast<double>(a.y - box_.min.y) * squares_per_nm_;
  double bx = static_cast<double>(b.x - box_.min.x) * squares_per_nm_;
  double by = static_cast<double>(b.y - box_.min.y) * squares_per_nm_;
  if (ay > by) std::swap(ax, bx), std::swap(ay, by);
  // Positive numbers are rounded down by their conversion to integers, without a function call.
  if (by + kSlack < 0) return false;
  const auto first_row = static_cast<int32_t>(std::clamp<double>(ay - kSlack, 0, rows_));
  const auto last_row = static_cast<int32_t>(std::min<double>(rows_ - 1, by + kSlack));
  // True if rows cut the edge, so that each has a part of it.
  const bool is_cut = by > ay && !(first_row == last_row && ay >= first_row && by <= first_row + 1);
  const double slope = is_cut ? (bx - ax) / (by - ay) : 0;
  for (int32_t row = first_row; row <= last_row; ++row) {
    double from = ax, to = bx;
    if (is_cut) {
      from = ax + (std::max<double>(row, ay) - ay) * slope;
      to = ax + (std::min<double>(row + 1, by) - ay) * slope;
    }
    if (from > to) std::swap(from, to);
    if (to + kSlack < 0 || from - kSlack >= columns_) continue;
    const auto first = static_cast<int32_t>(std::max(0.0, from - kSlack));
    const auto last = static_cast<int32_t>(std::min<double>(columns_ - 1, to + kSlack));
    if (visit(row, first, last)) return true;
  }
  return false;
}

bool RegionMask::RingMeets(const Polygon& ring) const {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (std::max(a.x, b.x) < box_.min.x || std::min(a.x, b.x) > box_.max.x ||
        std::max(a.y, b.y) < box_.min.y || std::min(a.y, b.y) > box_.max.y) {
      continue;
    }
    if (ForEachSpan(a, b, [this](int32_t row, int32_t first, int32_t last) {
          return AnyInSpan(row, first, last);
        })) {
      return true;
    }
  }
  return false;
}

void RegionMask::MarkBoundary(const Polygon& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    ForEachSpan(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1],
                [this](int32_t row, int32_t first, int32_t last) {
                  MarkSpan(row, first, last);
                  return false;
                });
  }
}

/// Marks the squares between the crossings of each row's middle. A square without boundary is in
/// the region if its middle is.
void RegionMask::MarkInside(const MultiPolygon& region) {
  std::vector<std::vector<double>> crossings(rows_);
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double ay = static_cast<double>(a.y - box_.min.y) * squares_per_nm_ - 0.5;
      const double by = static_cast<double>(b.y - box_.min.y) * squares_per_nm_ - 0.5;
      const double ax = static_cast<double>(a.x - box_.min.x) * squares_per_nm_;
      const double bx = static_cast<double>(b.x - box_.min.x) * squares_per_nm_;
      const double low = std::min(ay, by), high = std::max(ay, by);
      for (auto row = static_cast<int32_t>(std::ceil(std::max(0.0, low)));
           row < rows_ && row < high; ++row)
        crossings[row].push_back(ax + (row - ay) / (by - ay) * (bx - ax));
    }
  });
  for (int32_t row = 0; row < rows_; ++row) {
    std::sort(crossings[row].begin(), crossings[row].end());
    for (size_t k = 0; k + 1 < crossings[row].size(); k += 2) {
      const double from = std::max(0.0, std::ceil(crossings[row][k] - 0.5));
      const double to = std::min(columns_ - 1.0, std::floor(crossings[row][k + 1] - 0.5));
      if (from <= to) MarkSpan(row, static_cast<int32_t>(from), static_cast<int32_t>(to));
    }
  }
}

void RegionMask::MarkSpan(int32_t row, int32_t first, int32_t last) {
  uint64_t* const words = bits_.data() + static_cast<size_t>(row) * words_;
  const int32_t from = first / 64, to = last / 64;
  for (int32_t word = from; word <= to; ++word) {
    words[word] |= (word == from ? BitsFrom(first) : ~uint64_t{0}) &
                   (word == to ? BitsTo(last) : ~uint64_t{0});
  }
}

bool RegionMask::AnyInSpan(int32_t row, int32_t first, int32_t last) const {
  const uint64_t* const words = bits_.data() + static_cast<size_t>(row) * words_;
  const int32_t from = first / 64, to = last / 64;
  for (int32_t word = from; word <= to; ++word) {
    if (words[word] & (word == from ? BitsFrom(first) : ~uint64_t{0}) &
        (word == to ? BitsTo(last) : ~uint64_t{0})) {
      return true;
    }
  }
  return false;
}

}  // namespace slicefarm::infill
