#include "services/infill/algo/lines/tiled_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

constexpr double kSamePointNm = 3;

/// Returns the signed distance of p to the left of the line ab.
double LeftOf(Vector2 p, Vector2 a, Vector2 b) {
  const double u = b.x() - a.x(), v = b.y() - a.y();
  const double length = std::sqrt(u * u + v * v);
  if (length == 0)
    return std::sqrt((p.x() - a.x()) * (p.x() - a.x()) + (p.y() - a.y()) * (p.y() - a.y()));
  return (u * (p.y() - a.y()) - v * (p.x() - a.x())) / length;
}

/// Returns the greatest signed distance of the points between first and last from their chord.
double RiseOver(const std::vector<Vector2>& points, size_t first, size_t last) {
  double rise = 0;
  for (size_t i = first + 1; i < last; ++i) {
    const double height = LeftOf(points[i], points[first], points[last]);
    if (std::abs(height) > std::abs(rise)) rise = height;
  }
  return rise;
}

/// Returns the corners from `first` to `last`. Each chord is as long as the tolerance allows.
std::vector<size_t> Corners(const std::vector<Vector2>& points, size_t first, size_t last,
                            double tolerance) {
  std::vector<size_t> corners{first};
  while (corners.back() < last) {
    const size_t from = corners.back();
    size_t to = from + 1;
    while (to < last && std::abs(RiseOver(points, from, to + 1)) <= tolerance) ++to;
    corners.push_back(to);
  }
  return corners;
}

/// Returns a point moved by `by` to the left of its neighbours' chord.
Vector2 Moved(Vector2 p, Vector2 before, Vector2 after, double by) {
  const double u = after.x() - before.x(), v = after.y() - before.y();
  const double length = std::sqrt(u * u + v * v);
  return length == 0 ? p : Vector2{p.x() - by * v / length, p.y() + by * u / length};
}

Vector2 Shifted(Vector2 p, double u, double v) { return {p.x() + u, p.y() + v}; }

/// Extent of a line's points.
struct Reach {
  double min_u = 1e300, max_u = -1e300, min_v = 1e300, max_v = -1e300;
};
Reach ReachOf(const LevelLine& line) {
  Reach reach;
  for (const Vector2& p : line.points) {
    reach.min_u = std::min(reach.min_u, p.x()), reach.max_u = std::max(reach.max_u, p.x());
    reach.min_v = std::min(reach.min_v, p.y()), reach.max_v = std::max(reach.max_v, p.y());
  }
  return reach;
}

/// Copies of lines at all periods near a region.
class Tiler {
 public:
  Tiler(const LineAxes& frame, double period_nm, const FrameBox& box)
      : frame_(frame),
        period_nm_(period_nm),
        box_{box.min_u / period_nm, box.max_u / period_nm, box.min_v / period_nm,
             box.max_v / period_nm} {}

  std::vector<Curve> Tile(std::span<const LevelLine> lines) {
    for (const LevelLine& line : lines) line.IsClosed() ? TileClosed(line) : TileOpen(line);
    return std::move(curves_);
  }

 private:
  void TileClosed(const LevelLine& line) {
    const Reach reach = ReachOf(line);
    for (double v = std::ceil(box_.min_v - reach.max_v); v <= box_.max_v - reach.min_v; ++v) {
      for (double u = std::ceil(box_.min_u - reach.max_u); u <= box_.max_u - reach.min_u; ++u) {
        Curve& curve = curves_.emplace_back();
        curve.closed = true;
        Append(line, u, v, curve.points);
        if (curve.points.size() > 1 && curve.points.front() == curve.points.back())
          curve.points.pop_back();
      }
    }
  }

  /// Adds the copies of an open line. Consecutive copies form one curve. Copies of different curves
  /// are at steps (r, k) for r below |step_u| and all k, or with u and v exchanged.
  void TileOpen(const LevelLine& line) {
    const bool by_u = std::abs(line.step_u) >= std::abs(line.step_v);
    const int step = std::abs(by_u ? line.step_u : line.step_v);
    const int aside = by_u ? line.step_v : line.step_u;
    const Reach reach = ReachOf(line);
    const double from = std::ceil((by_u ? box_.min_u - reach.max_u : box_.min_v - reach.max_v));
    const double to = by_u ? box_.max_u - reach.min_u : box_.max_v - reach.min_v;
    const int sign = (by_u ? line.step_u : line.step_v) > 0 ? 1 : -1;
    const double copies = std::floor((to - from) / step) + 1;
    for (int r = 0; r < step; ++r) {
      // Copy k is at from + r + k * step on the main axis, and shifted by k * aside on the other
      // axis.
      const double drift = sign * aside * copies;
      const double low = by_u ? box_.min_v - reach.max_v : box_.min_u - reach.max_u;
      const double high = by_u ? box_.max_v - reach.min_v : box_.max_u - reach.min_u;
      for (double across = std::ceil(low - std::max(0.0, drift));
           across <= high - std::min(0.0, drift); ++across)
        Chain(line, by_u, from + r, across, step, sign * aside, sign < 0);
    }
  }

  /// Adds the copies of one curve near the region. `backward`: the line runs against the order of
  /// copies.
  void Chain(const LevelLine& line, bool by_u, double along, double across, int step, int aside,
             bool backward) {
    const Reach reach = ReachOf(line);
    std::vector<Vector2> places;
    const auto flush = [&] {
      if (places.empty()) return;
      if (backward) std::reverse(places.begin(), places.end());
      Curve& curve = curves_.emplace_back();
      for (const Vector2& at : places) Append(line, at.x(), at.y(), curve.points);
      places.clear();
    };
    const double to = by_u ? box_.max_u - reach.min_u : box_.max_v - reach.min_v;
    for (; along <= to; along += step, across += aside) {
      const double u = by_u ? along : across, v = by_u ? across : along;
      const bool near = u + reach.max_u >= box_.min_u && u + reach.min_u <= box_.max_u &&
                        v + reach.max_v >= box_.min_v && v + reach.min_v <= box_.max_v;
      if (near)
        places.push_back({u, v});
      else
        flush();
    }
    flush();
  }

  void Append(const LevelLine& line, double u, double v, Polyline& points) const {
    for (const Vector2& p : line.points) {
      const Point q = frame_.At((p.x() + u) * period_nm_, (p.y() + v) * period_nm_);
      // The last point of a copy equals the first point of the next copy, except for rounding.
      if (points.empty() || Distance(points.back(), q) > kSamePointNm) points.push_back(q);
    }
  }

  const LineAxes& frame_;
  const double period_nm_;
  const FrameBox box_;  ///< box of the region, in periods
  std::vector<Curve> curves_;
};

}  // namespace

LevelLine WithLongSegments(const LevelLine& line, double tolerance) {
  std::vector<Vector2> points = line.points;
  if (points.size() < 3) return line;
  if (line.IsClosed()) points.push_back(points[0]);
  const size_t last = points.size() - 1;
  // Corners are moved out by a third of the rise, so that chords may have 1.5 times the tolerance.
  const std::vector<size_t> corners = Corners(points, 0, last, 1.5 * tolerance);
  const size_t chords = corners.size() - 1;
  std::vector<double> rise(chords);
  for (size_t c = 0; c < chords; ++c) rise[c] = RiseOver(points, corners[c], corners[c + 1]);
  LevelLine out;
  out.step_u = line.step_u;
  out.step_v = line.step_v;
  for (size_t c = 0; c < chords; ++c) {
    const size_t b = (c + chords - 1) % chords;
    const Vector2 before =
        c > 0 ? points[corners[b]] : Shifted(points[corners[b]], -line.step_u, -line.step_v);
    out.points.push_back(
        Moved(points[corners[c]], before, points[corners[c + 1]], (rise[b] + rise[c]) / 6));
  }
  if (!line.IsClosed()) out.points.push_back(Shifted(out.points[0], line.step_u, line.step_v));
  return out;
}

absl::StatusOr<std::vector<Curve>> TiledLines(const MultiPolygon& region,
                                              std::span<const LevelLine> lines,
                                              const LineAxes& frame, double period_nm) {
  if (region.empty()) return std::vector<Curve>{};
  const FrameBox box = BoxIn(frame, region);
  const double periods =
      ((box.max_u - box.min_u) / period_nm + 2) * ((box.max_v - box.min_v) / period_nm + 2);
  if (absl::Status ok = CheckLineCount(periods * static_cast<double>(lines.size())); !ok.ok())
    return ok;
  return Tiler(frame, period_nm, box).Tile(lines);
}

}  // namespace slicefarm::infill
