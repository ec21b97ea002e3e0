#include "common/geometry/edge_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/geometry/predicates.h"

namespace slicefarm {
namespace {

/// Maximum number of squares per edge, in addition to a fixed number.
constexpr double kSquaresPerEdge = 4;
constexpr double kSquaresAnyway = 512;

/// Rounds down and up, without the function call of std::floor and std::ceil.
Coord Floor(double value) {
  const auto whole = static_cast<Coord>(value);
  return whole - (static_cast<double>(whole) > value ? 1 : 0);
}
Coord Ceil(double value) { return -Floor(-value); }

}  // namespace

EdgeIndex::EdgeIndex(const MultiPolygon& region, Coord square_nm) {
  edges_.reserve(PointCount(region));
  int32_t ring_number = 0;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Edge& edge = edges_.emplace_back();  // filled in place, which is faster than a copy
      edge.a = ring[i];
      edge.b = ring[i + 1 == ring.size() ? 0 : i + 1];
      edge.ring = ring_number;
      edge.edge = static_cast<int32_t>(i);
      box_.Add(ring[i]);
    }
    ++ring_number;
  });
  begin_ = {0, 0};
  if (edges_.empty()) {
    box_ = {{0, 0}, {0, 0}};
    return;
  }
  const double width = static_cast<double>(box_.max.x - box_.min.x) + 1;
  const double height = static_cast<double>(box_.max.y - box_.min.y) + 1;
  const double most = kSquaresAnyway + kSquaresPerEdge * static_cast<double>(edges_.size());
  const double square = std::max({static_cast<double>(square_nm), std::sqrt(width * height / most),
                                  width / most, height / most});
  square_bits_ = std::bit_width(static_cast<uint64_t>(square));
  columns_ = Column(box_.max.x) + 1;
  rows_ = Row(box_.max.y) + 1;
  begin_.assign(static_cast<size_t>(rows_) * columns_ + 1, 0);
  for (const Edge& edge : edges_) ForEachSquare(edge, [this](size_t number) { ++begin_[number]; });
  // Each square's items are filled in from behind, so that its begin moves from the end to the
  // first of them.
  for (size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  items_.resize(static_cast<size_t>(begin_.back()));
  for (size_t i = edges_.size(); i-- > 0;)
    ForEachSquare(edges_[i],
                  [&](size_t number) { items_[--begin_[number]] = static_cast<int32_t>(i); });
}

/// Visits the squares that an edge passes, row by row. In each row these are the columns from the
/// edge's entry to its exit, extended by one nanometre.
template <typename Visit>
void EdgeIndex::ForEachSquare(const Edge& edge, Visit visit) const {
  const Point low = edge.a.y <= edge.b.y ? edge.a : edge.b;
  const Point high = edge.a.y <= edge.b.y ? edge.b : edge.a;
  const auto [left, right] = std::minmax(low.x, high.x);
  const int32_t first_row = Row(low.y), last_row = Row(high.y);
  const double rise = static_cast<double>(high.y - low.y);
  const double slope = first_row < last_row ? static_cast<double>(high.x - low.x) / rise : 0;
  for (int32_t row = first_row; row <= last_row; ++row) {
    Coord from = left, to = right;
    if (first_row < last_row) {
      const Coord bottom = box_.min.y + (static_cast<Coord>(row) << square_bits_);
      const double x0 = slope * static_cast<double>(std::max(bottom, low.y) - low.y);
      const double x1 = slope * static_cast<double>(std::min(bottom + square_nm(), high.y) - low.y);
      from = std::max(left, low.x + Floor(std::min(x0, x1)) - 1);
      to = std::min(right, low.x + Ceil(std::max(x0, x1)) + 1);
    }
    const int32_t last_column = Column(to);
    for (int32_t column = Column(from); column <= last_column; ++column)
      visit(static_cast<size_t>(row) * columns_ + column);
  }
}

bool EdgeIndex::Meets(Point a, Point b) const {
  bool meets = false;
  ForEachNear({{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}},
              [&](int32_t number) {
                if (meets) return;
                const Edge& e = At(number);
                if (std::max(e.a.x, e.b.x) < std::min(a.x, b.x) ||
                    std::min(e.a.x, e.b.x) > std::max(a.x, b.x) ||
                    std::max(e.a.y, e.b.y) < std::min(a.y, b.y) ||
                    std::min(e.a.y, e.b.y) > std::max(a.y, b.y))
                  return;
                meets = Orientation(a, b, e.a) * Orientation(a, b, e.b) <= 0 &&
                        Orientation(e.a, e.b, a) * Orientation(e.a, e.b, b) <= 0;
              });
  return meets;
}

}  // namespace slicefarm
