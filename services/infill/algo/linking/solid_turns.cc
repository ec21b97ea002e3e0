#include "services/infill/algo/linking/solid_turns.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"
#include "services/infill/algo/linking/ring_way.h"

namespace slicefarm::infill {
namespace {

/// What the optimum comes to, in pitches, by the cotangent of the angle between lines and edge.
constexpr double kShiftSlope = 0.45, kBack = 0.7, kBackSlope = 0.15;
/// Of ends that would move by less, in pitches, the points cost more than the wedge.
constexpr double kLeastShift = 0.05;
/// Flatter edges count as one of 30 degrees.
constexpr double kMostCotangent = 1.73;
/// Of the way to the next end along the edge, and of a line: no end takes more.
constexpr double kMostShare = 0.45;

/// How an end of a link lies beyond its crossing, in pitches.
struct Bend {
  double shift = 0;  ///< along the edge
  double back = 0;   ///< along the line
};

/// None where the line leans over the link. `forward`: the link goes forwards along the ring from
/// the crossing.
Bend BendAt(const ScanLines& lines, const Crossing& crossing, bool forward) {
  const Polygon& ring = *lines.rings[crossing.ring];
  const Point a = ring[crossing.edge], b = ring[(crossing.edge + 1) % ring.size()];
  const double u = lines.frame.U(b) - lines.frame.U(a), v = lines.frame.V(b) - lines.frame.V(a);
  const double along = crossing.place % 2 == 0 ? u : -u;  // into the region
  const double cotangent =
      std::abs(u) < kMostCotangent * std::abs(v) ? std::abs(u / v) : kMostCotangent;
  const double shift = kShiftSlope * cotangent;
  if ((along > 0) == forward || shift < kLeastShift) return {};
  return {shift, kBack + kBackSlope * cotangent};
}

/// From a crossing to the next or the previous one on its ring, both with it.
Polyline WayFrom(const ScanLines& lines, int32_t from, bool forward) {
  const Crossing& a = lines.crossings[from];
  const Crossing& b = lines.crossings[forward ? a.next : a.previous];
  Polyline way = {lines.PlaceOf(a)};
  ForEachCorner(*lines.rings[a.ring], {a.edge, b.edge, forward},
                [&](Point p) { way.push_back(p); });
  way.push_back(lines.PlaceOf(b));
  return way;
}

/// A way without its first `length`.
Polyline Without(const Polyline& way, double length) {
  for (size_t i = 1; i < way.size(); ++i) {
    const double edge = Distance(way[i - 1], way[i]);
    if (edge < length) {
      length -= edge;
      continue;
    }
    const double t = edge > 0 ? length / edge : 0;
    const Point d = way[i] - way[i - 1];
    Polyline rest = {way[i - 1] + Point{std::llround(t * static_cast<double>(d.x)),
                                        std::llround(t * static_cast<double>(d.y))}};
    rest.insert(rest.end(), way.begin() + static_cast<int64_t>(i), way.end());
    return rest;
  }
  return {way.back()};
}

/// Bends one end of a link's way, its first point; returns how far back its line ends.
double BendStart(const ScanLines& lines, int32_t from, bool forward, Polyline& way) {
  const Crossing& crossing = lines.crossings[from];
  const Bend bend = BendAt(lines, crossing, forward);
  if (bend.shift <= 0) return 0;
  const Polyline beyond = WayFrom(lines, from, !forward);
  const double most_shift = kMostShare * Length(beyond);
  const double most_back = kMostShare * lines.PieceLength(crossing.place / 2);
  const double share = std::min(
      {1.0, most_shift / (bend.shift * lines.pitch), most_back / (bend.back * lines.pitch)});
  const double shift = share * bend.shift * lines.pitch;
  Polyline back(beyond.rbegin(), beyond.rend());
  back = Without(back, Length(beyond) - shift);
  way.insert(way.begin(), back.begin(), back.end() - 1);
  return share * bend.back * lines.pitch;
}

}  // namespace

SolidTurn TurnBetween(const ScanLines& lines, int32_t from, int32_t to, bool forward) {
  SolidTurn turn{.way = WayFrom(lines, from, forward)};
  turn.from_back_nm = BendStart(lines, from, forward, turn.way);
  std::ranges::reverse(turn.way);
  turn.to_back_nm = BendStart(lines, to, !forward, turn.way);
  std::ranges::reverse(turn.way);
  return turn;
}

}  // namespace slicefarm::infill
