#include "services/ordering/algo/comb/edge_strips.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/predicates.h"

namespace slicefarm::ordering {
namespace {

/// Largest rounding error of the point where a segment enters a strip, in nm.
constexpr Coord kSlack = 4;

bool SegmentsMeet(Point a, Point b, Point c, Point d) {
  const int c_side = Orientation(a, b, c), d_side = Orientation(a, b, d);
  if (c_side * d_side > 0) return false;
  const int a_side = Orientation(c, d, a), b_side = Orientation(c, d, b);
  if (a_side * b_side > 0) return false;
  if (c_side != 0 || d_side != 0 || a_side != 0 || b_side != 0) return true;
  // All four points are on one line.
  return OnSegment(a, c, d) || OnSegment(b, c, d) || OnSegment(c, a, b);
}

bool SegmentsCross(Point a, Point b, Point c, Point d) {
  return Orientation(a, b, c) * Orientation(a, b, d) < 0 &&
         Orientation(c, d, a) * Orientation(c, d, b) < 0;
}

/// Returns the x of the line ab at height y, rounded.
Coord XAt(Point a, Point b, Coord y) {
  if (y <= a.y) return a.x;
  if (y >= b.y) return b.x;
  const double share = static_cast<double>(y - a.y) / static_cast<double>(b.y - a.y);
  return a.x + std::llround(share * static_cast<double>(b.x - a.x));
}

}  // namespace

void EdgeStrips::AddRing(std::span<const Point> ring, uint32_t order) {
  if (ring.empty()) return;
  AddLine(ring, order);
  Add(ring.back(), ring.front(), order);
}

void EdgeStrips::AddLine(std::span<const Point> line, uint32_t order) {
  for (size_t i = 1; i < line.size(); ++i) Add(line[i - 1], line[i], order);
}

void EdgeStrips::Add(Point a, Point b, uint32_t order) {
  if (a.y > b.y) std::swap(a, b);
  edges_.push_back({a, b, order});
  box_.Add(a);
  box_.Add(b);
}

size_t EdgeStrips::StripOf(Coord y) const {
  return static_cast<size_t>((std::clamp(y, box_.min.y, box_.max.y) - box_.min.y) / height_);
}

std::span<const EdgeStrips::Edge> EdgeStrips::EdgesOf(size_t strip) const {
  return std::span(edges_).subspan(begins_[strip], begins_[strip + 1] - begins_[strip]);
}

void EdgeStrips::Build() {
  if (edges_.empty()) return;
  Coord heights = 0;
  for (const Edge& edge : edges_) heights += edge.high.y - edge.low.y;
  // Limits the number of strips to the number of edges, because level edges have no height.
  height_ = std::max(heights, box_.max.y - box_.min.y) / static_cast<Coord>(edges_.size()) + 1;
  begins_.assign(StripOf(box_.max.y) + 2, 0);
  const auto for_each_strip = [&](const Edge& edge, auto visit) {
    for (size_t i = StripOf(edge.low.y), last = StripOf(edge.high.y); i <= last; ++i) visit(i);
  };
  std::ranges::sort(edges_, {}, &Edge::left);
  for (const Edge& edge : edges_) for_each_strip(edge, [&](size_t i) { ++begins_[i + 1]; });
  for (size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  std::vector<Edge> by_strip(begins_.back());
  std::vector<size_t> ends(begins_.begin(), begins_.end() - 1);
  for (const Edge& edge : edges_)
    for_each_strip(edge, [&](size_t i) { by_strip[ends[i]++] = edge; });
  edges_ = std::move(by_strip);
}

template <typename Hit>
bool EdgeStrips::AnyNear(Point a, Point b, Hit hit) const {
  if (a.y > b.y) std::swap(a, b);
  const auto [left, right] = std::minmax(a.x, b.x);
  if (edges_.empty() || right < box_.min.x || left > box_.max.x || b.y < box_.min.y ||
      a.y > box_.max.y) {
    return false;
  }
  for (size_t i = StripOf(a.y), last = StripOf(b.y); i <= last; ++i) {
    const Coord bottom = box_.min.y + static_cast<Coord>(i) * height_;
    Coord from = XAt(a, b, bottom - kSlack), to = XAt(a, b, bottom + height_ + kSlack);
    if (from > to) std::swap(from, to);
    for (const Edge& edge : EdgesOf(i)) {
      if (edge.left() > to + kSlack) break;
      if (edge.right() >= from - kSlack && hit(edge)) return true;
    }
  }
  return false;
}

bool EdgeStrips::Meets(Point a, Point b) const {
  return AnyNear(a, b, [&](const Edge& edge) { return SegmentsMeet(a, b, edge.low, edge.high); });
}

bool EdgeStrips::Crosses(Point a, Point b, uint32_t before) const {
  return AnyNear(a, b, [&](const Edge& edge) {
    return edge.order < before && SegmentsCross(a, b, edge.low, edge.high);
  });
}

bool EdgeStrips::Surrounds(Point p) const {
  if (edges_.empty() || p.y < box_.min.y || p.y > box_.max.y) return false;
  bool inside = false;
  for (const Edge& edge : EdgesOf(StripOf(p.y))) {
    if (edge.left() > p.x) break;
    if (edge.low.y <= p.y && p.y < edge.high.y && Orientation(edge.low, edge.high, p) < 0)
      inside = !inside;
  }
  return inside;
}

}  // namespace slicefarm::ordering
