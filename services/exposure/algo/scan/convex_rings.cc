#include "services/exposure/algo/scan/convex_rings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "services/exposure/algo/scan/corner_spurs.h"

namespace slicefarm::exposure {
namespace {

/// The spine is the middle line if this line has at least this share of the lower line's length.
constexpr double kAsLong = 0.95;
/// Sine of the smallest angle between two lines that meet in a corner; below it they count as
/// parallel.
constexpr double kParallel = 1e-12;
/// Largest width of the unmelted middle, as a share of the pitch, that is too narrow for a line.
constexpr double kFits = 0.02;
constexpr double kDepthNm = 1'000;

/// Returns the ring rounded to nm, with the first point repeated at the end. A result of less than
/// 4 points is no ring.
Polyline ClosedLine(const ConvexRing& ring) {
  Polyline line;
  for (const Vector2& p : ring)
    if (const Point q = RoundedPoint(p); line.empty() || q != line.back()) line.push_back(q);
  while (line.size() > 1 && line.back() == line.front()) line.pop_back();
  if (!line.empty()) line.push_back(line.front());
  return line;
}

/// Returns ring `k` of a piece, with spurs if RingFill::turn selects this ring. `gap`: outer
/// boundary of the area that ring k - 1 leaves unmelted; not used for the outermost ring.
ConvexRing Spurred(const ConvexRing& ring, int64_t k, const ConvexRing& gap, const RingFill& fill) {
  const bool has_turn = !fill.turn || (k + fill.turn->corner) % kCornerTurns == 0;
  if (!fill.corners || !has_turn) return ring;
  if (k > 0) return gap.empty() ? ring : WithSpurs(ring, gap, fill.spurs);
  if (fill.border == nullptr) return ring;
  return WithOuterSpurs(ring, fill.first_nm, *fill.border, fill.spurs);
}

}  // namespace

ConvexInsets::ConvexInsets(const Polygon& piece, double scale) {
  const auto place = [&](size_t i) {
    return Vector2{static_cast<double>(piece[i].x) / scale,
                   static_cast<double>(piece[i].y) / scale};
  };
  for (size_t i = 0; i < piece.size(); ++i) {
    const Vector2 a = place(i), b = place((i + 1) % piece.size());
    const double length = Norm(b - a);
    if (length > 0) edges_.push_back({a, {(b.x() - a.x()) / length, (b.y() - a.y()) / length}});
  }
}

ConvexRing ConvexInsets::At(double distance) {
  // Intersects half planes in the order of their directions. `lines` from index `front` on are the
  // lines that contribute a side to the intersection so far.
  struct Line {
    Vector2 at = Vector2::Zero(), direction = Vector2::Zero();
    size_t edge = 0;
  };
  std::vector<Line> lines;
  std::vector<Vector2> corners;  // corners[i] is between lines[i] and lines[i + 1]
  lines.reserve(edges_.size());
  corners.reserve(edges_.size());
  size_t front = 0;
  const auto meet = [](const Line& a, const Line& b) {
    const double t = Cross(b.direction, a.at - b.at) / Cross(a.direction, b.direction);
    return Vector2{a.at.x() + t * a.direction.x(), a.at.y() + t * a.direction.y()};
  };
  const auto outside = [](const Line& line, Vector2 p) {
    return Cross(line.direction, p - line.at) <= 0;
  };
  for (size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const Line line{
        {edge.at.x() - distance * edge.direction.y(), edge.at.y() + distance * edge.direction.x()},
        edge.direction,
        i};
    while (lines.size() > front + 1 && outside(line, corners.back())) {
      lines.pop_back();
      corners.pop_back();
    }
    while (lines.size() > front + 1 && outside(line, corners[front])) ++front;
    if (lines.size() > front) {
      const double turn = Cross(lines.back().direction, line.direction);
      if (turn < -kParallel ||
          (turn <= kParallel && Dot(lines.back().direction, line.direction) < 0))
        return {};
      if (turn <= kParallel) {  // same direction: the inner line counts
        if (outside(lines.back(), line.at)) continue;
        lines.pop_back();
        if (lines.size() > front) corners.pop_back();
        if (lines.size() > front) corners.push_back(meet(lines.back(), line));
        lines.push_back(line);
        continue;
      }
      corners.push_back(meet(lines.back(), line));
    }
    lines.push_back(line);
  }
  while (lines.size() > front + 2 && outside(lines[front], corners.back())) {
    lines.pop_back();
    corners.pop_back();
  }
  while (lines.size() > front + 2 && outside(lines.back(), corners[front])) ++front;
  if (lines.size() < front + 3 ||
      Cross(lines.back().direction, lines[front].direction) <= kParallel)
    return {};
  ConvexRing ring(corners.begin() + static_cast<ptrdiff_t>(front), corners.end());
  ring.push_back(meet(lines.back(), lines[front]));
  std::vector<Edge> left;
  for (size_t i = front; i < lines.size(); ++i) left.push_back(edges_[lines[i].edge]);
  edges_ = std::move(left);
  return ring;
}

double ConvexInsets::Depth() {
  ConvexRing border = At(0);
  double twice_area = 0, around = 0;
  for (size_t i = 0; i < border.size(); ++i) {
    const Vector2 a = border[i], b = border[(i + 1) % border.size()];
    twice_area += Cross(a - border[0], b - border[0]);
    around += Norm(b - a);
  }
  if (!(around > 0)) return 0;
  // Bounds of the depth: the depth is at most 2 * area / perimeter. A circle with half this radius
  // fits into any convex polygon, so this is the lower bound.
  double low = twice_area / around / 2, high = 2 * low;
  while (high - low > kDepthNm) {
    const double middle = (low + high) / 2;
    (At(middle).empty() ? high : low) = middle;
  }
  return high;
}

namespace {

/// Longest side of a polygon, and the polygon's extent perpendicular to it.
struct Base {
  Vector2 at = Vector2::Zero(), direction = Vector2::Zero();
  double width = std::numeric_limits<double>::infinity();
};

/// Returns the longest side of a convex polygon and the polygon's width from this side.
Base BaseOf(const ConvexRing& ring) {
  Base base;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i], side = ring[(i + 1) % ring.size()] - a;
    const double length = Norm(side);
    if (!(length > 0)) continue;
    const Vector2 unit{side.x() / length, side.y() / length};
    double farthest = 0;
    for (const Vector2& p : ring) farthest = std::max(farthest, Cross(unit, p - a));
    if (farthest < base.width) base = {a, unit, farthest};
  }
  return base;
}

/// Returns the line parallel to the base at the distance `height`, from boundary to boundary.
Spine Chord(const ConvexRing& ring, const Base& base, double height) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - base.at, b = ring[(i + 1) % ring.size()] - base.at;
    const double up_a = Cross(base.direction, a) - height, up_b = Cross(base.direction, b) - height;
    if ((up_a < 0) == (up_b < 0)) continue;
    const double t = up_a / (up_a - up_b);
    const double u = Dot(base.direction, a) + t * (Dot(base.direction, b) - Dot(base.direction, a));
    low = std::min(low, u);
    high = std::max(high, u);
  }
  const auto place = [&](double u) {
    return Vector2{base.at.x() + u * base.direction.x() - height * base.direction.y(),
                   base.at.y() + u * base.direction.y() + height * base.direction.x()};
  };
  return {place(low), place(high), base.width};
}

double LengthOf(const Spine& spine) { return Norm(spine.to - spine.from); }

/// Returns the part of a spine that is far enough from the region's border, or nullopt if there is
/// none.
std::optional<std::pair<Point, Point>> Cleared(const Spine& spine, const RingFill& fill) {
  const Point from = RoundedPoint(spine.from), to = RoundedPoint(spine.to);
  if (fill.border == nullptr) return std::pair(from, to);
  return fill.border->LongestRun(from, to, fill.spine_gap_nm);
}

}  // namespace

Spine SpineOf(const ConvexRing& ring) {
  const Base base = BaseOf(ring);
  return Chord(ring, base, base.width / 2);
}

Spine SpineOf(const ConvexRing& ring, double spot_nm) {
  const Base base = BaseOf(ring);
  const Spine middle = Chord(ring, base, base.width / 2);
  // Smallest distance from the base at which the spot still reaches the farthest corner. It is at
  // most half a spot, so that the spot also reaches the base. It is at least 5 % of the width,
  // because a line on the base could vanish by rounding.
  const double least = 0.05 * base.width;
  const double height = std::clamp(base.width - spot_nm / 2, least, std::max(least, spot_nm / 2));
  const Spine low = Chord(ring, base, height);
  return LengthOf(middle) < kAsLong * LengthOf(low) ? low : middle;
}

namespace {

/// Shift of the inner rings towards the boundary: the index of the first shifted ring, and the
/// distance.
struct Nearer {
  int64_t from = 0;
  double by_nm = 0;
  /// Index of the first ring without spurs. Spurs of inner rings would be at the same position as
  /// the links in the middle.
  int64_t plain_from = std::numeric_limits<int64_t>::max();
};

/// Returns the shift after which opposite sides of the innermost ring are a pitch apart, so that
/// nothing in the middle stays unmelted.
Nearer NearerOf(const Polygon& piece, double scale, const RingFill& fill) {
  if (!fill.turn) return {};
  const double depth = ConvexInsets(piece, scale).Depth() - fill.first_nm;
  if (depth < kTurnedRings * fill.pitch_nm) return {};
  const double innermost = std::ceil(depth / fill.pitch_nm - 0.5 - kFits);
  return {std::llround(std::floor(fill.turn->nearer * innermost)) + 1,
          std::max(0.0, (innermost + 0.5) * fill.pitch_nm - depth), std::llround(innermost) - 2};
}

}  // namespace

std::vector<Polyline> ConvexRings(const Polygon& piece, double scale, const RingFill& fill) {
  std::vector<Polyline> rings;
  const Nearer nearer = NearerOf(piece, scale, fill);
  ConvexInsets insets(piece, scale);
  // Distance from the boundary up to which the rings so far have melted the piece.
  double reached = fill.first_nm - fill.pitch_nm / 2;
  ConvexRing gap;  // border of the area melted so far, around the next ring
  for (int64_t k = 0;; ++k) {
    ConvexInsets before = insets;
    const double distance = fill.first_nm + static_cast<double>(k) * fill.pitch_nm -
                            (k >= nearer.from ? nearer.by_nm : 0);
    const ConvexRing ring = insets.At(distance);
    if (ring.empty()) {
      insets = std::move(before);
      break;
    }
    Polyline line = ClosedLine(k < nearer.plain_from ? Spurred(ring, k, gap, fill) : ring);
    reached = distance + fill.pitch_nm / 2;
    if (line.size() < 4) break;
    rings.push_back(std::move(line));
    // The first shifted ring may overlap the area that ring k has melted. Then there is no gap
    // between them.
    gap = fill.corners && k + 1 != nearer.from ? insets.At(reached) : ConvexRing{};
  }
  const ConvexRing rest = insets.At(std::max(0.0, reached));
  if (rest.size() < 3) return rings;
  const Spine spine = SpineOf(rest, fill.pitch_nm);
  if (spine.width_nm < fill.least_spine * fill.pitch_nm) return rings;
  // If no ring surrounds the spine, the spine could be too near to the boundary.
  const auto line = rings.empty() ? Cleared(spine, fill)
                                  : std::pair(RoundedPoint(spine.from), RoundedPoint(spine.to));
  if (line && line->first != line->second) rings.push_back({line->first, line->second});
  return rings;
}

}  // namespace slicefarm::exposure
