#include "services/infill/algo/lines/rounded_corners.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"

namespace slicefarm::infill {
namespace {

constexpr double kParabolaToleranceNm = 10'000;
constexpr Coord kCornerSquareNm = 1'000'000;
/// Cosines of the largest and the smallest turn that is rounded: 155 and 5 degrees.
constexpr double kSharpCosine = -0.906, kStraightCosine = 0.9962;

Point Between(Point a, Point b, double share) {
  return a + Point{std::llround(share * static_cast<double>(b.x - a.x)),
                   std::llround(share * static_cast<double>(b.y - a.y))};
}

/// Returns the points of the parabola at a corner, or the corner if it stays.
Polyline RoundCorner(const EdgeIndex& walls, double share, Point before, Point at, Point after) {
  const double in = Distance(before, at), out = Distance(at, after);
  if (in == 0 || out == 0) return {at};
  const double cosine = Dot(at - before, after - at) / (in * out);
  if (cosine < kSharpCosine || cosine > kStraightCosine) return {at};
  const double reach = share / 2 * std::min(in, out);
  const Point from = Between(at, before, reach / in), to = Between(at, after, reach / out);
  const double bend = Distance(from + to, at + at);
  const double steps = std::max(2.0, std::ceil(std::sqrt(bend / (4 * kParabolaToleranceNm))));
  Polyline curve;
  for (double i = 0; i <= steps; ++i) {
    const double t = i / steps;
    curve.push_back(Between(Between(from, at, t), Between(at, to, t), t));
  }
  // The curve is tested, because a hole can be on it and meet neither its chord nor the line.
  for (size_t i = 1; i < curve.size(); ++i)
    if (walls.Meets(curve[i - 1], curve[i])) return {at};
  return curve;
}

}  // namespace

void RoundCorners(const MultiPolygon& region, double share, std::vector<Piece>& pieces) {
  if (region.empty()) return;
  const EdgeIndex walls(region, kCornerSquareNm);
  for (Piece& piece : pieces) {
    const size_t count = piece.points.size();
    Polyline rounded;
    const auto add = [&rounded](Point p) {
      if (rounded.empty() || rounded.back() != p) rounded.push_back(p);
    };
    for (size_t i = 0; i < count; ++i) {
      const bool is_end = !piece.closed && (i == 0 || i + 1 == count);
      if (is_end) {
        add(piece.points[i]);
        continue;
      }
      const Point before = piece.points[(i + count - 1) % count];
      const Point after = piece.points[(i + 1) % count];
      for (const Point p : RoundCorner(walls, share, before, piece.points[i], after)) add(p);
    }
    if (piece.closed && rounded.size() > 1 && rounded.front() == rounded.back()) rounded.pop_back();
    piece.points = std::move(rounded);
  }
}

}  // namespace slicefarm::infill
