#include "services/planning/algo/infill/edge_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace slicefarm::planning {
namespace {

Box BoxOf(const Edge& edge) {
  Box box;
  box.Add(edge.a);
  box.Add(edge.b);
  return box;
}

}  // namespace

EdgeGrid::EdgeGrid(const MultiPolygon& region) {
  Box all;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      edges_.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  });
  if (edges_.empty()) return;
  for (const Edge& edge : edges_) all.Add(BoxOf(edge));
  corner_ = all.min;
  const auto wide = static_cast<double>(all.max.x - all.min.x + 1);
  const auto high = static_cast<double>(all.max.y - all.min.y + 1);
  side_ =
      std::max<Coord>(1, std::llround(std::sqrt(wide / static_cast<double>(edges_.size()) * high)));
  width_ = (all.max.x - all.min.x) / side_ + 1;
  height_ = (all.max.y - all.min.y) / side_ + 1;
  begins_.assign(static_cast<size_t>(width_ * height_ + 1), 0);
  const auto each = [&](const auto& visit) {
    for (size_t i = 0; i < edges_.size(); ++i) {
      const Cells cells = CellsOf(BoxOf(edges_[i]));
      for (int64_t y = cells.first_y; y <= cells.last_y; ++y)
        for (int64_t x = cells.first_x; x <= cells.last_x; ++x)
          visit(static_cast<size_t>(y * width_ + x), static_cast<int32_t>(i));
    }
  };
  each([&](size_t cell, int32_t) { ++begins_[cell + 1]; });
  for (size_t cell = 1; cell < begins_.size(); ++cell) begins_[cell] += begins_[cell - 1];
  places_.resize(static_cast<size_t>(begins_.back()));
  std::vector<int32_t> next(begins_.begin(), begins_.end() - 1);
  each([&](size_t cell, int32_t edge) { places_[static_cast<size_t>(next[cell]++)] = edge; });
}

EdgeGrid::Cells EdgeGrid::CellsOf(const Box& box) const {
  const auto cell = [&](Coord at, int64_t count) {
    return std::clamp<int64_t>(at < 0 ? 0 : at / side_, 0, count - 1);
  };
  return {cell(box.min.x - corner_.x, width_), cell(box.min.y - corner_.y, height_),
          cell(box.max.x - corner_.x, width_), cell(box.max.y - corner_.y, height_)};
}

std::span<const int32_t> EdgeGrid::EdgesIn(int64_t x, int64_t y) const {
  const auto cell = static_cast<size_t>(y * width_ + x);
  return std::span(places_).subspan(static_cast<size_t>(begins_[cell]),
                                    static_cast<size_t>(begins_[cell + 1] - begins_[cell]));
}

std::optional<Nearest> EdgeGrid::NearestTo(Point p) const {
  if (edges_.empty()) return std::nullopt;
  Nearest best{{}, std::numeric_limits<double>::infinity()};
  int32_t best_edge = -1;
  const auto look = [&](int64_t x, int64_t y) {
    for (const int32_t i : EdgesIn(x, y)) {
      const Edge& edge = edges_[static_cast<size_t>(i)];
      const Point at = NearestOnSegment(p, edge.a, edge.b);
      const double distance = Distance(p, at);
      // Of places that are as near, that on the region's first edge, wherever the cells lie.
      if (distance > best.distance_nm || (distance == best.distance_nm && i >= best_edge)) continue;
      best = {at, distance};
      best_edge = i;
    }
  };
  const Cells home = CellsOf({p, p});
  for (int64_t ring = 0; ring < std::max(width_, height_); ++ring) {
    // Cells so many steps away lie at least one side less away.
    if (best.distance_nm < static_cast<double>((ring - 1) * side_)) break;
    for (int64_t y = home.first_y - ring; y <= home.first_y + ring; ++y) {
      if (y < 0 || y >= height_) continue;
      const bool whole = y == home.first_y - ring || y == home.first_y + ring;
      for (int64_t x = home.first_x - ring; x <= home.first_x + ring;
           x += whole || ring == 0 ? 1 : 2 * ring)
        if (0 <= x && x < width_) look(x, y);
    }
  }
  return best;
}

bool EdgeGrid::IsInside(Point p) const {
  if (edges_.empty() || p.y < corner_.y || p.y >= corner_.y + height_ * side_) return false;
  const int64_t row = (p.y - corner_.y) / side_;
  bool inside = false;
  for (int64_t x = 0; x < width_; ++x) {
    for (const int32_t i : EdgesIn(x, row)) {
      const Edge& edge = edges_[static_cast<size_t>(i)];
      if ((edge.a.y > p.y) == (edge.b.y > p.y)) continue;
      // An edge is in several cells of the row: it counts in that of its least x.
      const Coord least = std::min(edge.a.x, edge.b.x);
      if ((least - corner_.x) / side_ != x) continue;
      const bool left = Cross(edge.b - edge.a, p - edge.a) > 0;
      if (left == (edge.b.y > edge.a.y)) inside = !inside;
    }
  }
  return inside;
}

std::vector<Edge> EdgeGrid::Near(Point a, Point b) const {
  std::vector<int32_t> found;
  if (edges_.empty()) return {};
  const Cells cells = CellsOf(BoxOf({a, b}));
  for (int64_t y = cells.first_y; y <= cells.last_y; ++y)
    for (int64_t x = cells.first_x; x <= cells.last_x; ++x)
      std::ranges::copy(EdgesIn(x, y), std::back_inserter(found));
  std::ranges::sort(found);
  const auto rest = std::ranges::unique(found);
  found.erase(rest.begin(), rest.end());
  std::vector<Edge> edges;
  for (const int32_t i : found) edges.push_back(edges_[static_cast<size_t>(i)]);
  return edges;
}

}  // namespace slicefarm::planning
