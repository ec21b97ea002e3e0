#include "services/infill/algo/lines/fitted_strips.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "common/base/portable_math.h"
#include "services/infill/algo/lines/ring_path.h"

namespace slicefarm::infill {
namespace {

/// Smallest length of a flat part of the boundary, in pitches along the lines. On a shorter part,
/// the round ends of lines leave little empty, and each fitted end costs some extra moves.
constexpr double kLeastFlatPitches = 1.0;
/// Largest slope of a flat part of the boundary, relative to the lines.
constexpr double kSteepSlope = 0.5;
/// Length of the space that the round end of a line fills, in pitches.
constexpr double kEndPitches = 0.35;
/// Smallest distance between corners of a strip, in pitches.
constexpr double kLeastStepPitches = 0.25;
/// Widths of the narrowest and the widest strip, in pitches.
constexpr double kNarrowest = 0.6;
constexpr double kWidest = 1.5;

}  // namespace

StripPoint Between(const StripPoint& a, const StripPoint& b, double share) {
  const auto between = [&](Coord from, Coord to) {
    return from + std::llround(share * static_cast<double>(to - from));
  };
  return {{between(a.at.x, b.at.x), between(a.at.y, b.at.y)},
          a.strip_nm + share * (b.strip_nm - a.strip_nm)};
}

FittedStrips::FittedStrips(const ScanLines& lines, const Options& options) : lines_(lines) {
  for (size_t i = 0; i < lines.crossings.size(); ++i) {
    const auto from = static_cast<int32_t>(i);
    if (const auto flat = FlatFrom(from, options.reach_nm))
      AddSpan(*flat, from, options.linked[i] ? options.link_nm : 0);
  }
  std::ranges::sort(extra_widths_, {}, [](const ExtraWidth& extra) {
    return std::tuple(extra.side, extra.knots.front().u, extra.knots.back().u);
  });
}

/// Returns the points along the boundary from a crossing to the next one, in the frame.
std::vector<Vector2> FittedStrips::CurveOf(int32_t from) const {
  const Crossing& a = lines_.crossings[from];
  const Crossing& b = lines_.crossings[a.next];
  std::vector<Vector2> curve = {{a.u, lines_.VOf(a.line)}};
  ForEachCorner(*lines_.rings[a.ring], {a.edge, b.edge, true}, [&](Point p) {
    curve.push_back({lines_.frame.U(p), lines_.frame.V(p)});
  });
  curve.push_back({b.u, lines_.VOf(b.line)});
  return curve;
}

/// Returns the lower one of the two lines between which a part of the boundary runs.
int32_t FittedStrips::LineBelow(int32_t from, const std::vector<Vector2>& curve) const {
  const Crossing& a = lines_.crossings[from];
  const int32_t other = lines_.crossings[a.next].line;
  if (a.line != other) return std::min(a.line, other);
  const auto [lowest, highest] =
      std::ranges::minmax(curve, {}, [](const Vector2& p) { return p.y(); });
  const double v = lines_.VOf(a.line);
  return highest.y() - v > v - lowest.y() ? a.line : a.line - 1;
}

/// Returns the piece of a line that is beside the whole part of the boundary, or -1 if there is
/// none.
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

std::optional<FittedStrips::FlatSpan> FittedStrips::FlatFrom(int32_t from, double reach_nm) const {
  const Crossing* start = &lines_.crossings[from];
  const Crossing* end = &lines_.crossings[start->next];
  const double least = kLeastFlatPitches * lines_.pitch;
  if (std::abs(end->u - start->u) < least) return std::nullopt;

  FlatSpan flat{.curve = CurveOf(from)};
  std::vector<Vector2>& curve = flat.curve;
  const int32_t below = LineBelow(from, curve);
  // The region is to the left of its boundary.
  flat.region_above = end->u > start->u;
  if (!flat.region_above) std::ranges::reverse(curve);
  if (!std::ranges::is_sorted(curve, {}, [](const Vector2& p) { return p.x(); }))
    return std::nullopt;
  flat.line = flat.region_above ? below + 1 : below;
  flat.piece = PieceBeside(flat.line, curve.front().x(), curve.back().x());
  if (flat.piece < 0) return std::nullopt;

  // Steep ends of the part are treated like normal ends of lines: the flat part ends before them.
  const auto steep = [](const Vector2& a, const Vector2& b) {
    return std::abs(b.y() - a.y()) > kSteepSlope * (b.x() - a.x());
  };
  flat.last = curve.size() - 1;
  while (flat.first < flat.last && steep(curve[flat.first], curve[flat.first + 1])) ++flat.first;
  while (flat.first < flat.last && steep(curve[flat.last - 1], curve[flat.last])) --flat.last;
  const double width = curve[flat.last].x() - curve[flat.first].x();
  if (width < least) return std::nullopt;
  double length = 0;
  for (size_t i = flat.first; i < flat.last; ++i)
    length += Hypot(curve[i + 1].x() - curve[i].x(), curve[i + 1].y() - curve[i].y());
  flat.reach_nm = reach_nm * length / width;
  return flat;
}

/// Returns the distance from the boundary to the far side of the strip of the line beside the
/// boundary.
double FittedStrips::ExtraWidthAt(const FlatSpan& flat, size_t i) const {
  return std::abs(flat.curve[i].y() - lines_.VOf(flat.line)) + flat.reach_nm + lines_.pitch / 2;
}

void FittedStrips::AddSpan(const FlatSpan& flat, int32_t from, double link_nm) {
  std::vector<Knot> edge;
  for (size_t i = flat.first; i <= flat.last; ++i) {
    const double strip = std::clamp(ExtraWidthAt(flat, i) - link_nm, kNarrowest * lines_.pitch,
                                    kWidest * lines_.pitch);
    edge.push_back({flat.curve[i].x(), strip - lines_.pitch});
  }
  const Crossing* start = &lines_.crossings[from];
  const Crossing* end = &lines_.crossings[start->next];
  if (!flat.region_above) std::swap(start, end);
  edge.front().u = start->u;
  edge.back().u = end->u;
  extra_widths_.push_back(
      {2 * flat.piece + (flat.region_above ? 0 : 1),
       Joined(std::move(edge), start->place / 2 == flat.piece, end->place / 2 == flat.piece)});
}

/// Returns the extra width of a strip along a flat part of the boundary. At an end that belongs to
/// another line, the extra width begins with 0, because the round end of that line is there.
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

/// Returns the knots on one side of a piece. If flat parts overlap, the first one counts.
std::vector<FittedStrips::Knot> FittedStrips::KnotsOf(int32_t side) const {
  std::vector<Knot> knots;
  for (auto it = std::ranges::lower_bound(extra_widths_, side, {}, &ExtraWidth::side);
       it != extra_widths_.end() && it->side == side; ++it) {
    const ExtraWidth& extra = *it;
    if (knots.empty() || extra.knots.front().u >= knots.back().u)
      knots.insert(knots.end(), extra.knots.begin(), extra.knots.end());
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
