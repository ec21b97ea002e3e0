#include "services/infill/algo/linking/solid_beads.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"
#include "services/infill/algo/linking/solid_turns.h"

namespace slicefarm::infill {
namespace {

/// A turn that comes to its end narrower than so many pitches goes on by so many pitches: the room
/// behind it is a wedge that no line fills.
constexpr double kNarrowTip = 0.9;
constexpr double kTipPitches = 0.4;
/// Rounding may bring an end so much nearer to the edge.
constexpr double kRoundingNm = 10;

/// By crossing, whether a link runs from it to the next one.
std::vector<bool> LinkedStretches(const ScanLines& lines,
                                  const std::vector<SerpentinePath>& paths) {
  std::vector<bool> linked(lines.crossings.size(), false);
  for (const SerpentinePath& path : paths)
    for (const int32_t from : path.stretches) linked[from] = true;
  return linked;
}

/// Takes `length_nm` off the end of a bead.
void Shorten(double length_nm, std::vector<StripPoint>& bead) {
  while (bead.size() > 2) {
    const double edge = Distance(bead[bead.size() - 2].at, bead.back().at);
    if (edge > length_nm) break;
    length_nm -= edge;
    bead.pop_back();
  }
  const StripPoint before = bead[bead.size() - 2];
  const double edge = Distance(before.at, bead.back().at);
  if (edge > 0) bead.back() = Between(bead.back(), before, std::min(1.0, length_nm / edge));
}

}  // namespace

SolidBeads::SolidBeads(const PolygonWithHoles& region, const ScanLines& lines,
                       const std::vector<SerpentinePath>& paths, const Options& options)
    : lines_(lines),
      options_(options),
      edges_({region}, std::llround(lines.pitch)),
      fitted_(options.fitted ? FittedStrips(lines, LinkedStretches(lines, paths), options.linked_nm)
                             : FittedStrips(lines)),
      even_(lines) {}

SolidBeads::Bead SolidBeads::BeadOf(const SerpentinePath& path) const {
  Bead bead = LineFrom(path.places[0]);
  bead.insert(bead.begin(), FreeEnd(path.places[0], bead.front()));
  for (size_t piece = 0; piece + 1 < path.pieces.size(); ++piece) {
    Bead next = LineFrom(path.places[piece + 1]);
    AppendLink(path, piece, bead, next);
    bead.insert(bead.end(), next.begin(), next.end());
  }
  bead.push_back(FreeEnd(path.places.back() ^ 1, bead.back()));
  return bead;
}

/// The strip of a piece, from the crossing at `place` to its other end.
SolidBeads::Bead SolidBeads::LineFrom(int32_t place) const {
  Bead fitted = fitted_.From(place), even = even_.From(place);
  if (fitted == even) return even;
  const bool leaves = Leaves(even.front().at, fitted.front().at) ||
                      Leaves(fitted.back().at, even.back().at) || Leaves(fitted);
  return leaves ? even : fitted;
}

/// Appends the link behind a piece to the bead, which ends with that piece; `next` is the strip of
/// the next piece.
void SolidBeads::AppendLink(const SerpentinePath& path, size_t piece, Bead& bead,
                            Bead& next) const {
  if (options_.fitted &&
      (AppendFitted(path, piece, bead, next) || AppendTurn(path, piece, bead, next)))
    return;
  for (int32_t i = path.pieces[piece] + 2; i < path.pieces[piece + 1]; ++i)
    bead.push_back({path.points[i], lines_.pitch});
}

bool SolidBeads::AppendFitted(const SerpentinePath& path, size_t piece, Bead& bead,
                              Bead& next) const {
  Bead link = fitted_.LinkFrom(path.stretches[piece]);
  if (link.empty()) return false;
  const int32_t end = path.places[piece] ^ 1, start = path.places[piece + 1];
  if (lines_.order[end] != path.stretches[piece]) std::ranges::reverse(link);
  if (Leaves(bead.back().at, link.front().at) || Leaves(link) ||
      Leaves(link.back().at, next.front().at))
    return false;
  link.insert(link.begin(), link.front());
  link.push_back(link.back());
  ExtendTip(end, bead.back(), link.front());
  ExtendTip(start, next.front(), link.back());
  bead.insert(bead.end(), link.begin(), link.end());
  return true;
}

bool SolidBeads::AppendTurn(const SerpentinePath& path, size_t piece, Bead& bead,
                            Bead& next) const {
  const int32_t from = lines_.order[path.places[piece] ^ 1];
  const SolidTurn turn = TurnBetween(lines_, from, lines_.order[path.places[piece + 1]],
                                     path.stretches[piece] == from);
  Bead before(bead.end() - 2, bead.end()), after = next;
  Shorten(turn.from_back_nm, before);
  std::ranges::reverse(after);
  Shorten(turn.to_back_nm, after);
  std::ranges::reverse(after);
  if (Leaves(before.back().at, turn.way.front()) || Leaves(turn.way.back(), after.front().at))
    return false;
  bead.back() = before.back();
  next = std::move(after);
  for (const Point p : turn.way) bead.push_back({p, lines_.pitch});
  return true;
}

/// Moves the ends of a line and of its link on along the line, if they are narrow there.
void SolidBeads::ExtendTip(int32_t place, StripPoint& line_end, StripPoint& link_end) const {
  if (link_end.strip_nm > kNarrowTip * lines_.pitch) return;
  const double more = (place % 2 == 0 ? -kTipPitches : kTipPitches) * lines_.pitch;
  const StripPoint line = Along(line_end, more), link = Along(link_end, more);
  if (Leaves(line_end.at, line.at) || Leaves(line.at, link.at) || Leaves(link.at, link_end.at))
    return;
  line_end = line;
  link_end = link;
}

/// An end that no link leads on from, nearer to the edge.
StripPoint SolidBeads::FreeEnd(int32_t place, StripPoint end) const {
  const double nearer = options_.linked_nm - options_.free_nm;
  if (nearer <= 0) return end;
  const Crossing& crossing = lines_.crossings[lines_.order[place]];
  const Polygon& ring = *lines_.rings[crossing.ring];
  const Point a = ring[crossing.edge], b = ring[(crossing.edge + 1) % ring.size()];
  const double rise = std::abs(lines_.frame.V(b) - lines_.frame.V(a));
  const double more =
      rise * lines_.pitch > nearer * Distance(a, b) ? nearer * Distance(a, b) / rise : lines_.pitch;
  const StripPoint at = Along(end, place % 2 == 0 ? -more : more);
  if (Leaves(end.at, at.at) ||
      DistanceToEdge(at.at, options_.linked_nm) + kRoundingNm < options_.free_nm)
    return end;
  return at;
}

/// A place farther along the lines.
StripPoint SolidBeads::Along(StripPoint p, double u_nm) const {
  p.at = lines_.frame.At(lines_.frame.U(p.at) + u_nm, lines_.frame.V(p.at));
  return p;
}

bool SolidBeads::Leaves(const Bead& bead) const {
  for (size_t i = 1; i < bead.size(); ++i)
    if (Leaves(bead[i - 1].at, bead[i].at)) return true;
  return false;
}

double SolidBeads::DistanceToEdge(Point p, double at_most_nm) const {
  const auto reach = static_cast<Coord>(at_most_nm);
  double nearest = at_most_nm;
  const Box box{{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}};
  edges_.ForEachNear(box, [&](int32_t i) {
    nearest = std::min(nearest, DistanceToSegment(p, edges_.At(i).a, edges_.At(i).b));
  });
  return nearest;
}

}  // namespace slicefarm::infill
