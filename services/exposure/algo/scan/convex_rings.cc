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

/// A spine runs along the middle if it is at least as long there, as a share.
constexpr double kAsLong = 0.95;
/// Lines closer to parallel than this have no corner.
constexpr double kParallel = 1e-12;
/// Less than this is left in the middle, as a share of the pitch: too narrow for a line.
constexpr double kFits = 0.02;
constexpr double kDepthNm = 1'000;

/// Rounded to nm, with the first point again at the end. Less than 4 points: no ring.
Polyline ClosedLine(const ConvexRing& ring) {
  Polyline line;
  for (const Vector2& p : ring)
    if (const Point q = RoundedPoint(p); line.empty() || q != line.back()) line.push_back(q);
  while (line.size() > 1 && line.back() == line.front()) line.pop_back();
  if (!line.empty()) line.push_back(line.front());
  return line;
}

/// Ring `k` of a piece with spurs, if it has its turn; `gap`: what it leaves open around it, except
/// of the outermost.
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
  // The common part of half planes in the order of their directions: a deque of those that have a
  // side of it so far.
  struct Line {
    Vector2 at = Vector2::Zero(), way = Vector2::Zero();
    size_t edge = 0;
  };
  std::vector<Line> lines;
  std::vector<Vector2> corners;  // corners[i]: of lines[i] and lines[i + 1]
  lines.reserve(edges_.size());
  corners.reserve(edges_.size());
  size_t front = 0;
  const auto meet = [](const Line& a, const Line& b) {
    const double t = Cross(b.way, a.at - b.at) / Cross(a.way, b.way);
    return Vector2{a.at.x() + t * a.way.x(), a.at.y() + t * a.way.y()};
  };
  const auto outside = [](const Line& line, Vector2 p) {
    return Cross(line.way, p - line.at) <= 0;
  };
  for (size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const Line line{{edge.at.x() - distance * edge.way.y(), edge.at.y() + distance * edge.way.x()},
                    edge.way,
                    i};
    while (lines.size() > front + 1 && outside(line, corners.back())) {
      lines.pop_back();
      corners.pop_back();
    }
    while (lines.size() > front + 1 && outside(line, corners[front])) ++front;
    if (lines.size() > front) {
      const double turn = Cross(lines.back().way, line.way);
      if (turn < -kParallel || (turn <= kParallel && Dot(lines.back().way, line.way) < 0))
        return {};
      if (turn <= kParallel) {  // the same direction: the inner one counts
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
  if (lines.size() < front + 3 || Cross(lines.back().way, lines[front].way) <= kParallel) return {};
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
  // A circle of half of the greatest depth that area and length allow fits into any convex polygon.
  double low = twice_area / around / 2, high = 2 * low;
  while (high - low > kDepthNm) {
    const double middle = (low + high) / 2;
    (At(middle).empty() ? high : low) = middle;
  }
  return high;
}

namespace {

/// The longest side's line, and how far the polygon reaches from it.
struct Base {
  Vector2 at = Vector2::Zero(), way = Vector2::Zero();
  double width = std::numeric_limits<double>::infinity();
};

/// The width of a convex polygon is measured from one of its sides.
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

/// The line at `height` over the base, from border to border.
Spine Chord(const ConvexRing& ring, const Base& base, double height) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - base.at, b = ring[(i + 1) % ring.size()] - base.at;
    const double up_a = Cross(base.way, a) - height, up_b = Cross(base.way, b) - height;
    if ((up_a < 0) == (up_b < 0)) continue;
    const double t = up_a / (up_a - up_b);
    const double u = Dot(base.way, a) + t * (Dot(base.way, b) - Dot(base.way, a));
    low = std::min(low, u);
    high = std::max(high, u);
  }
  const auto place = [&](double u) {
    return Vector2{base.at.x() + u * base.way.x() - height * base.way.y(),
                   base.at.y() + u * base.way.y() + height * base.way.x()};
  };
  return {place(low), place(high), base.width};
}

double LengthOf(const Spine& spine) { return Norm(spine.to - spine.from); }

/// What of a spine keeps far enough from the region's border; nullopt: nothing.
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
  // Down to where the spot still reaches the top, but not the base's other side; not onto the base
  // itself, of which rounding may leave nothing.
  const double least = 0.05 * base.width;
  const double height = std::clamp(base.width - spot_nm / 2, least, std::max(least, spot_nm / 2));
  const Spine low = Chord(ring, base, height);
  return LengthOf(middle) < kAsLong * LengthOf(low) ? low : middle;
}

namespace {

/// From which ring on rings are nearer, and by how much.
struct Nearer {
  int64_t from = 0;
  double by_nm = 0;
  /// Rings from here on have no spurs, which lie where all links of the middle do.
  int64_t plain_from = std::numeric_limits<int64_t>::max();
};

/// So that the innermost ring's sides are a pitch apart, and nothing is left in the middle.
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
  // Up to where the rings melt: what lies deeper has not been reached yet.
  double reached = fill.first_nm - fill.pitch_nm / 2;
  ConvexRing gap;  // where a ring ends to melt, around the next one
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
    // The next one may lie where this one has melted: nothing is open between them.
    gap = fill.corners && k + 1 != nearer.from ? insets.At(reached) : ConvexRing{};
  }
  const ConvexRing rest = insets.At(std::max(0.0, reached));
  if (rest.size() < 3) return rings;
  const Spine spine = SpineOf(rest, fill.pitch_nm);
  if (spine.width_nm < fill.least_spine * fill.pitch_nm) return rings;
  // Where there is no ring around it, nothing keeps it off the border.
  const auto line = rings.empty() ? Cleared(spine, fill)
                                  : std::pair(RoundedPoint(spine.from), RoundedPoint(spine.to));
  if (line && line->first != line->second) rings.push_back({line->first, line->second});
  return rings;
}

}  // namespace slicefarm::exposure
