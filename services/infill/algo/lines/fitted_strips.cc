#include "services/infill/algo/lines/fitted_strips.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "common/base/portable_math.h"
#include "services/infill/algo/linking/ring_way.h"

namespace slicefarm::infill {
namespace {

/// Shorter stretches of the edge, in pitches along the lines, are no flat ones: at steeper angles
/// the round ends of lines leave little, and each fitted end takes some moves more.
constexpr double kLeastFlatPitches = 1.5;
/// The round end of a line takes so much of the room beyond it, in pitches.
constexpr double kEndPitches = 0.5;
/// Corners of a strip lie at least so far apart, in pitches.
constexpr double kLeastStepPitches = 0.25;
/// The narrowest and the widest strip, in pitches.
constexpr double kNarrowest = 0.1;
constexpr double kWidest = 2.0;

}  // namespace

FittedStrips::FittedStrips(const ScanLines& lines, const std::vector<bool>& linked, double reach_nm)
    : lines_(lines) {
  for (size_t i = 0; i < lines.crossings.size(); ++i)
    AddStretch(static_cast<int32_t>(i), linked[i] ? -reach_nm : reach_nm);
  std::ranges::sort(rooms_, {}, [](const Room& room) {
    return std::tuple(room.side, room.knots.front().u, room.knots.back().u);
  });
}

/// The way along the edge from a crossing to the next one.
std::vector<FittedStrips::FramePoint> FittedStrips::WayOf(int32_t from) const {
  const Crossing& a = lines_.crossings[from];
  const Crossing& b = lines_.crossings[a.next];
  std::vector<FramePoint> way = {{a.u, lines_.VOf(a.line)}};
  ForEachCorner(*lines_.rings[a.ring], {a.edge, b.edge, true}, [&](Point p) {
    way.push_back({lines_.frame.U(p), lines_.frame.V(p)});
  });
  way.push_back({b.u, lines_.VOf(b.line)});
  return way;
}

/// The lower one of the two lines that a stretch of the edge runs between.
int32_t FittedStrips::LineBelow(int32_t from, const std::vector<FramePoint>& way) const {
  const Crossing& a = lines_.crossings[from];
  const int32_t other = lines_.crossings[a.next].line;
  if (a.line != other) return std::min(a.line, other);
  const auto [lowest, highest] = std::ranges::minmax(way, {}, &FramePoint::v);
  const double v = lines_.VOf(a.line);
  return highest.v - v > v - lowest.v ? a.line : a.line - 1;
}

/// The piece of a line that reaches over all of a stretch; -1: there is none.
int32_t FittedStrips::PieceBeside(int32_t line, double from_u, double to_u) const {
  if (line < 0 || line >= lines_.LineCount()) return -1;
  const auto begin = lines_.order.begin() + lines_.line_begin[line];
  const auto end = lines_.order.begin() + lines_.line_begin[line + 1];
  const auto after = std::partition_point(
      begin, end, [&](int32_t crossing) { return lines_.crossings[crossing].u < to_u; });
  const auto place = static_cast<int32_t>(after - lines_.order.begin());
  if (after == end || place % 2 == 0) return -1;
  return lines_.crossings[*std::prev(after)].u <= from_u ? place / 2 : -1;
}

void FittedStrips::AddStretch(int32_t from, double reach_nm) {
  const Crossing* start = &lines_.crossings[from];
  const Crossing* end = &lines_.crossings[start->next];
  const double least = kLeastFlatPitches * lines_.pitch;
  if (std::abs(end->u - start->u) < least) return;

  std::vector<FramePoint> way = WayOf(from);
  const int32_t below = LineBelow(from, way);
  // The region lies to the left of its edge.
  const bool region_above = end->u > start->u;
  if (!region_above) {
    std::ranges::reverse(way);
    std::swap(start, end);
  }
  if (!std::ranges::is_sorted(way, {}, &FramePoint::u)) return;
  const int32_t line = region_above ? below + 1 : below;
  const int32_t piece = PieceBeside(line, start->u, end->u);
  if (piece < 0) return;

  // Steep ends are as other ends of lines are: what is flat goes on up to them.
  const auto steep = [](const FramePoint& a, const FramePoint& b) {
    return std::abs(b.v - a.v) > b.u - a.u;
  };
  size_t first = 0, last = way.size() - 1;
  while (first < last && steep(way[first], way[first + 1])) ++first;
  while (first < last && steep(way[last - 1], way[last])) --last;
  if (way[last].u - way[first].u < least) return;

  double length = 0;
  for (size_t i = first; i < last; ++i)
    length += Hypot(way[i + 1].u - way[i].u, way[i + 1].v - way[i].v);
  const double reach = reach_nm * length / (way[last].u - way[first].u);
  std::vector<Knot> edge;
  for (size_t i = first; i <= last; ++i) {
    const double room = std::abs(way[i].v - lines_.VOf(line)) + reach;
    edge.push_back(
        {way[i].u, std::clamp(room - lines_.pitch / 2, -lines_.pitch / 2, lines_.pitch / 2)});
  }
  edge.front().u = start->u;
  edge.back().u = end->u;
  rooms_.push_back({2 * piece + (region_above ? 0 : 1),
                    Joined(std::move(edge), start->place / 2 == piece, end->place / 2 == piece)});
}

/// What a strip gets of the room before the edge. At an end of another line it begins with nothing:
/// that line's round end lies there.
std::vector<FittedStrips::Knot> FittedStrips::Joined(std::vector<Knot> edge, bool own_start,
                                                     bool own_end) const {
  const double ramp = kEndPitches * lines_.pitch, step = kLeastStepPitches * lines_.pitch;
  const double from = edge.front().u, to = edge.back().u;
  std::vector<Knot> knots = {{from, own_start ? edge.front().more_nm : 0}};
  if (!own_start) knots.push_back({from + ramp, MoreAt(edge, from + ramp)});
  const double last = own_end ? to : to - ramp;
  for (const Knot& knot : edge)
    if (knot.u >= knots.back().u + step && knot.u <= last - step) knots.push_back(knot);
  if (!own_end && last > knots.back().u) knots.push_back({last, MoreAt(edge, last)});
  knots.push_back({to, own_end ? edge.back().more_nm : 0});
  return knots;
}

double FittedStrips::MoreAt(const std::vector<Knot>& knots, double u) {
  if (knots.empty()) return 0;
  const auto after = std::ranges::lower_bound(knots, u, {}, &Knot::u);
  if (after == knots.end()) return knots.back().more_nm;
  if (after == knots.begin()) return after->more_nm;
  const Knot &a = *std::prev(after), &b = *after;
  return a.more_nm + (b.more_nm - a.more_nm) * (u - a.u) / (b.u - a.u);
}

/// Of stretches over one another, the first counts.
std::vector<FittedStrips::Knot> FittedStrips::KnotsOf(int32_t side) const {
  std::vector<Knot> knots;
  for (auto it = std::ranges::lower_bound(rooms_, side, {}, &Room::side);
       it != rooms_.end() && it->side == side; ++it) {
    const Room& room = *it;
    if (knots.empty() || room.knots.front().u >= knots.back().u)
      knots.insert(knots.end(), room.knots.begin(), room.knots.end());
  }
  return knots;
}

std::vector<StripPoint> FittedStrips::From(int32_t place) const {
  const int32_t piece = place / 2;
  const Crossing& start = lines_.crossings[lines_.order[2 * piece]];
  const Crossing& end = lines_.crossings[lines_.order[2 * piece + 1]];
  const std::vector<Knot> below = KnotsOf(2 * piece), above = KnotsOf(2 * piece + 1);
  std::vector<double> corners = {start.u, end.u};
  for (const std::vector<Knot>* side : {&below, &above})
    for (const Knot& knot : *side) corners.push_back(knot.u);
  std::ranges::sort(corners);

  std::vector<StripPoint> strip;
  const double step = kLeastStepPitches * lines_.pitch;
  double last = start.u - step;
  for (const double u : corners) {
    const bool is_end = u == end.u;
    if (!is_end && (u < last + step || u > end.u - step) && u != start.u) continue;
    if (!strip.empty() && u == last) continue;
    const double low = MoreAt(below, u), high = MoreAt(above, u);
    const double width =
        std::clamp(lines_.pitch + low + high, kNarrowest * lines_.pitch, kWidest * lines_.pitch);
    strip.push_back({lines_.frame.At(u, lines_.VOf(start.line) + (high - low) / 2), width});
    last = u;
  }
  if (place % 2 != 0) std::ranges::reverse(strip);
  return strip;
}

}  // namespace slicefarm::infill
