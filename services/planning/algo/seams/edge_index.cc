#include "services/planning/algo/seams/edge_index.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::planning {
namespace {

constexpr Coord kLeastCellNm = 1 * kNmPerMm;
/// Bounds the memory of a grid over few edges that lie far apart.
constexpr double kCellsAnyway = 4096;
constexpr double kCellsPerEdge = 4;
/// The same where many edges are long: in how many cells they lie, in all and each.
constexpr double kMembersAnyway = 1'000'000;
constexpr double kMembersPerEdge = 32;

/// `reach_nm`: the sum of the edges' extents in x and y.
Coord CellSize(const Box& box, size_t edges, double reach_nm) {
  const auto count = static_cast<double>(edges);
  const double area = static_cast<double>(box.max.x - box.min.x + kLeastCellNm) *
                      static_cast<double>(box.max.y - box.min.y + kLeastCellNm);
  const double by_cells = std::sqrt(area / (kCellsAnyway + kCellsPerEdge * count));
  const double by_members = reach_nm / (kMembersAnyway + kMembersPerEdge * count);
  return std::max(kLeastCellNm, static_cast<Coord>(std::max(by_cells, by_members)));
}

}  // namespace

EdgeIndex::EdgeIndex(const MultiPolygon& outlines) {
  int32_t ring_count = 0;
  ForEachRing(outlines, [&](const Polygon& ring) { AddRing(ring, ring_count++); });
  if (edges_.empty()) return;
  double reach_nm = 0;
  for (const Edge& edge : edges_)
    reach_nm += static_cast<double>(std::abs(edge.to.x - edge.from.x) +
                                    std::abs(edge.to.y - edge.from.y));
  cell_nm_ = CellSize(box_, edges_.size(), reach_nm);
  columns_ = Column(box_.max.x) + 1;
  rows_ = Row(box_.max.y) + 1;
  FillCells();
}

void EdgeIndex::AddRing(const Polygon& ring, int32_t number) {
  const size_t n = ring.size();
  first_edge_.push_back(static_cast<int32_t>(edges_.size()));
  for (size_t i = 0; i < n; ++i) {
    const Point before = ring[(i + n - 1) % n], at = ring[i], next = ring[(i + 1) % n];
    const bool reflex = Cross(at - before, next - at) < 0;
    edges_.push_back({at, next, number, static_cast<int32_t>(i), reflex});
    box_.Add(at);
  }
}

Coord EdgeIndex::Column(Coord x) const { return (x - box_.min.x) / cell_nm_; }
Coord EdgeIndex::Row(Coord y) const { return (y - box_.min.y) / cell_nm_; }

/// Calls visit(cell) for all cells that an edge goes through, row by row, and a few beside.
template <typename Visit>
void EdgeIndex::ForEachCell(const Edge& edge, const Visit& visit) const {
  const auto [low, high] = std::minmax(edge.from, edge.to, [](Point a, Point b) {
    return a.y < b.y;
  });
  const double slope = low.y == high.y ? 0
                                       : static_cast<double>(high.x - low.x) /
                                             static_cast<double>(high.y - low.y);
  for (Coord row = Row(low.y); row <= Row(high.y); ++row) {
    const Coord bottom = std::max(box_.min.y + row * cell_nm_, low.y);
    const Coord top = std::min(box_.min.y + (row + 1) * cell_nm_, high.y);
    const auto x_at = [&](Coord y) {
      return low.x + static_cast<Coord>(slope * static_cast<double>(y - low.y));
    };
    const Coord at_bottom = x_at(bottom), at_top = low.y == high.y ? high.x : x_at(top);
    const Coord first = Column(std::max(std::min(at_bottom, at_top) - 1, box_.min.x));
    const Coord last = std::min(Column(std::max(at_bottom, at_top) + 1), columns_ - 1);
    for (Coord column = first; column <= last; ++column)
      visit(static_cast<size_t>(row * columns_ + column));
  }
}

void EdgeIndex::FillCells() {
  const auto for_each_cell = [&](const auto& visit) {
    for (size_t i = 0; i < edges_.size(); ++i)
      ForEachCell(edges_[i], [&](size_t cell) { visit(cell, static_cast<int32_t>(i)); });
  };
  first_.assign(static_cast<size_t>(columns_ * rows_) + 1, 0);
  for_each_cell([&](size_t cell, int32_t) { ++first_[cell + 1]; });
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(static_cast<size_t>(first_.back()));
  std::vector<int32_t> next(first_.begin(), first_.end() - 1);
  for_each_cell([&](size_t cell, int32_t edge) {
    members_[static_cast<size_t>(next[cell]++)] = edge;
  });
}

void EdgeIndex::LookInto(Coord column, Coord row, Point to, Best& best) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
  const auto cell = static_cast<size_t>(row * columns_ + column);
  for (int32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
    const int32_t number = members_[static_cast<size_t>(i)];
    const Edge& edge = edges_[static_cast<size_t>(number)];
    const Point along = edge.to - edge.from, away = to - edge.from;
    const double length2 = SquaredNorm(along);
    const double share =
        length2 > 0 ? std::clamp(Dot(along, away) / length2, 0.0, 1.0) : 0.0;
    const double dx = static_cast<double>(away.x) - share * static_cast<double>(along.x);
    const double dy = static_cast<double>(away.y) - share * static_cast<double>(along.y);
    const double distance2 = dx * dx + dy * dy;
    if (distance2 > best.distance2) continue;
    if (distance2 == best.distance2 && best.edge >= 0 && number >= best.edge) continue;
    best = {distance2, number, share};
  }
}

std::optional<EdgeIndex::Hit> EdgeIndex::Nearest(Point to, Coord reach_nm) const {
  if (edges_.empty() || !box_.Grown(reach_nm).Intersects({to, to})) return {};
  const auto floor_div = [this](Coord a) {
    return a >= 0 ? a / cell_nm_ : -((-a + cell_nm_ - 1) / cell_nm_);
  };
  const Coord column = floor_div(to.x - box_.min.x), row = floor_div(to.y - box_.min.y);
  const auto reach = static_cast<double>(reach_nm);
  Best best{reach * reach, -1, 0};
  // Cells at a growing distance: what lies further out than k cells is further than k - 1 of them
  // and what is left of this one.
  for (Coord k = 0;; ++k) {
    for (Coord y = row - k; y <= row + k; ++y) {
      const bool rim = y == row - k || y == row + k;
      for (Coord x = column - k; x <= column + k; x += rim ? 1 : 2 * k)
        LookInto(x, y, to, best);
    }
    const double seen = static_cast<double>(k) * static_cast<double>(cell_nm_);
    if (seen >= reach || (best.edge >= 0 && best.distance2 <= seen * seen)) break;
  }
  if (best.edge < 0) return {};
  const Edge& edge = edges_[static_cast<size_t>(best.edge)];
  return Hit{edge.ring, edge.index, best.share, std::sqrt(best.distance2), IsInside(to, best)};
}

bool EdgeIndex::IsInside(Point p, const Best& best) const {
  const Edge& edge = edges_[static_cast<size_t>(best.edge)];
  if (best.share > 0 && best.share < 1)
    return Cross(edge.to - edge.from, p - edge.from) >= 0;
  if (best.distance2 == 0) return true;
  // Nearest to a corner: from inside only if that points inwards.
  if (best.share == 0) return edge.reflex;
  const auto ring = static_cast<size_t>(edge.ring);
  const auto end = ring + 1 < first_edge_.size() ? first_edge_[ring + 1]
                                                 : static_cast<int32_t>(edges_.size());
  const int32_t next = best.edge + 1 < end ? best.edge + 1 : first_edge_[ring];
  return edges_[static_cast<size_t>(next)].reflex;
}

}  // namespace slicefarm::planning
