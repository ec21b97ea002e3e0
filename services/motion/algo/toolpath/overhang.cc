#include "services/motion/algo/toolpath/overhang.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

constexpr Coord kSquareNm = kNmPerMm / 2;
constexpr double kRestingPieceMm = 1;
/// Largest difference of supported shares at which two pieces count as equally supported.
constexpr double kAlike = 0.05;
/// Shares at the ends of a piece are rounded to steps of 1 / kAirSteps. The piece counts as air if
/// their sum is less than 2 steps, otherwise as supported.
constexpr double kAirSteps = 20;
/// Offset in nm that is added to whole nanometres. No corner of an outline has such a coordinate.
constexpr double kAside = 0.3183;

/// Returns the squared distance from a point to an edge, nm^2.
double SquaredDistance(Point p, Point from, Point to) {
  const double x = static_cast<double>(to.x - from.x), y = static_cast<double>(to.y - from.y);
  const double px = static_cast<double>(p.x - from.x), py = static_cast<double>(p.y - from.y);
  const double squared = x * x + y * y;
  const double along = squared > 0 ? std::clamp((px * x + py * y) / squared, 0.0, 1.0) : 0;
  const double dx = px - along * x, dy = py - along * y;
  return dx * dx + dy * dy;
}

/// Returns the x where the edge crosses the height y, or nothing. Only one of the edge's two ends
/// counts as part of the edge.
std::optional<double> XAt(double y, Point from, Point to) {
  const auto from_y = static_cast<double>(from.y), to_y = static_cast<double>(to.y);
  if ((from_y > y) == (to_y > y)) return std::nullopt;
  return static_cast<double>(from.x) +
         (y - from_y) / (to_y - from_y) * static_cast<double>(to.x - from.x);
}

/// Returns the y where the edge crosses the line at x, or nothing. Like XAt with exchanged axes.
std::optional<double> YAt(double x, Point from, Point to) {
  return XAt(x, {from.y, from.x}, {to.y, to.x});
}

/// Returns the position where the line meets the edge, as a share of the line's length; -1 if it
/// does not.
double Meeting(Point from, Point to, Point a, Point b) {
  const auto cross = [](Point u, Point v) {
    return static_cast<double>(u.x) * static_cast<double>(v.y) -
           static_cast<double>(u.y) * static_cast<double>(v.x);
  };
  const double beside_a = cross(to - from, a - from), beside_b = cross(to - from, b - from);
  if ((beside_a > 0) == (beside_b > 0)) return -1;
  const double whole = cross(to - from, b - a);
  if (whole == 0) return -1;
  const double share = cross(a - from, b - a) / whole;
  return share >= 0 && share <= 1 ? share : -1;
}

}  // namespace

LayerBelow::LayerBelow(const MultiPolygon& outlines) : edges_(outlines, kSquareNm) {
  if (edges_.size() > 0) FindMiddlesInside();
}

/// Returns the middle of a square. It is offset from whole nanometres, so that no corner of an
/// outline is on the horizontal or vertical line through it.
Vector2 LayerBelow::MiddleOf(int32_t row, int32_t column) const {
  const auto square = static_cast<double>(edges_.square_nm());
  const Point least = edges_.bounds().min;
  return {static_cast<double>(least.x) + (column + 0.5) * square + kAside,
          static_cast<double>(least.y) + (row + 0.5) * square + kAside};
}

/// Finds the square middles inside the outlines, by counting edges to their left, row by row.
void LayerBelow::FindMiddlesInside() {
  const Box& box = edges_.bounds();
  columns_ = edges_.Column(box.max.x) + 1;
  const int32_t rows = edges_.Row(box.max.y) + 1;
  middle_inside_.assign(static_cast<size_t>(rows) * columns_, false);
  for (int32_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_.At(i);
    const int32_t last = edges_.Row(std::max(edge.a.y, edge.b.y));
    for (int32_t row = edges_.Row(std::min(edge.a.y, edge.b.y)); row <= last; ++row) {
      const auto x = XAt(MiddleOf(row, 0).y(), edge.a, edge.b);
      if (!x) continue;
      int32_t column = edges_.Column(static_cast<Coord>(*x));
      if (MiddleOf(row, column).x() < *x) ++column;
      if (column == columns_) continue;
      const auto square = static_cast<size_t>(row) * columns_ + column;
      middle_inside_[square] = !middle_inside_[square];
    }
  }
  for (size_t square = 1; square < middle_inside_.size(); ++square)
    if (square % columns_ != 0)
      middle_inside_[square] = middle_inside_[square] != middle_inside_[square - 1];
}

double LayerBelow::RestOf(Point point, Coord width_nm) const {
  if (edges_.size() == 0) return 0;
  const Coord reach = width_nm / 2;
  const Box near = {{point.x - reach, point.y - reach}, {point.x + reach, point.y + reach}};
  double nearest = static_cast<double>(reach) * static_cast<double>(reach);
  edges_.ForEachNear(near, [&](int32_t i) {
    const Edge& edge = edges_.At(i);
    if (std::max(edge.a.x, edge.b.x) < near.min.x || std::min(edge.a.x, edge.b.x) > near.max.x ||
        std::max(edge.a.y, edge.b.y) < near.min.y || std::min(edge.a.y, edge.b.y) > near.max.y)
      return;
    nearest = std::min(nearest, SquaredDistance(point, edge.a, edge.b));
  });
  const double out = std::sqrt(nearest) * (Covers(point) ? -1 : 1);
  return std::clamp(0.5 - out / static_cast<double>(width_nm), 0.0, 1.0);
}

/// Counts the edges between the point and the middle of its square, first along y, then along x.
bool LayerBelow::Covers(Point point) const {
  const Box& box = edges_.bounds();
  if (edges_.size() == 0 || point.x < box.min.x || point.x > box.max.x || point.y < box.min.y ||
      point.y > box.max.y)
    return false;
  const int32_t row = edges_.Row(point.y), column = edges_.Column(point.x);
  const Vector2 middle = MiddleOf(row, column);
  const double x = static_cast<double>(point.x) + kAside, y = static_cast<double>(point.y);
  bool inside = middle_inside_[static_cast<size_t>(row) * columns_ + column];
  edges_.ForEachNear({point, point}, [&](int32_t i) {
    const Edge& edge = edges_.At(i);
    if (const auto at = YAt(x, edge.a, edge.b); at && (*at > y) != (*at > middle.y()))
      inside = !inside;
    if (const auto at = XAt(middle.y(), edge.a, edge.b); at && (*at > x) != (*at > middle.x()))
      inside = !inside;
  });
  return inside;
}

std::vector<double> LayerBelow::EdgesOn(Point from, Point to) const {
  std::vector<double> shares;
  if (edges_.size() == 0) return shares;
  const Box box = {{std::min(from.x, to.x), std::min(from.y, to.y)},
                   {std::max(from.x, to.x), std::max(from.y, to.y)}};
  edges_.ForEachNear(box, [&](int32_t i) {
    const double share = Meeting(from, to, edges_.At(i).a, edges_.At(i).b);
    if (share >= 0) shares.push_back(share);
  });
  // An edge may be in several squares, so its share may be found more than once.
  std::ranges::sort(shares);
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  return shares;
}

namespace {

/// Caches the result for a point, because it is the end of one segment and the beginning of the
/// next one.
class Look {
 public:
  Look(const LayerBelow& below, RestSteps steps) : below_(below), steps_(steps) {}

  double RestOf(Point point, Coord width_nm) {
    if (point != at_ || width_nm != width_nm_) {
      at_ = point;
      width_nm_ = width_nm;
      // A point within the outlines is supported by at least half, even near the outlines.
      const bool is_enough = steps_ == RestSteps::kAirAlone && below_.Covers(point);
      rest_ = is_enough ? 1 : below_.RestOf(point, width_nm);
    }
    return rest_;
  }

 private:
  const LayerBelow& below_;
  const RestSteps steps_;
  Point at_;
  Coord width_nm_ = -1;  ///< -1: no point so far
  double rest_ = 0;
};

/// Range of the supported shares of consecutive pieces that count as equally supported.
struct Alike {
  double least = 0, most = 0;

  bool Take(double rest) {
    const double low = std::min(least, rest), high = std::max(most, rest);
    const bool is_end = IsEnd(rest) || IsEnd(least);
    if (high - low > (is_end ? 0 : kAlike)) return false;
    least = low;
    most = high;
    return true;
  }
  uint8_t Rest() const { return static_cast<uint8_t>(std::lround((least + most) / 2 * kFullRest)); }

 private:
  static bool IsEnd(double rest) { return rest == 0 || rest == 1; }
};

/// Returns the supported share of a piece from the shares at its ends. Values close to 0 or 1
/// become 0 or 1.
double RestBetween(double from, double to, RestSteps steps) {
  if (steps == RestSteps::kAirAlone)
    return std::lround(from * kAirSteps) + std::lround(to * kAirSteps) < 2 ? 0 : 1;
  const double rest = (from + to) / 2;
  if (rest < kAlike / 2) return 0;
  return rest > 1 - kAlike / 2 ? 1 : rest;
}

}  // namespace

std::vector<RestingPiece> PiecesOver(const LayerBelow& below, RestSteps steps,
                                     std::span<const PathSegment> segments) {
  Look look(below, steps);
  std::vector<RestingPiece> pieces;
  std::optional<Alike> alike;
  size_t first_alike = 0;
  const auto close = [&] {
    for (size_t i = first_alike; i < pieces.size(); ++i) pieces[i].rest = alike->Rest();
    first_alike = pieces.size();
  };
  for (size_t segment = 0; segment < segments.size(); ++segment) {
    const auto& [from, to, width_nm] = segments[segment];
    const auto count =
        std::max<int64_t>(1, std::llround(std::ceil(ToMm(Distance(from, to)) / kRestingPieceMm)));
    double before = look.RestOf(from, width_nm);
    for (int64_t i = 1; i <= count; ++i) {
      const Point end = {from.x + (to.x - from.x) * i / count,
                         from.y + (to.y - from.y) * i / count};
      const double at_end = look.RestOf(end, width_nm);
      const double rest = RestBetween(before, at_end, steps);
      before = at_end;
      const bool goes_on = alike && alike->Take(rest);
      if (!goes_on && alike) close();
      if (!goes_on) alike = Alike{rest, rest};
      if (goes_on && i > 1) {
        pieces.back().to = end;
      } else {
        pieces.push_back({segment, end});
      }
    }
  }
  if (alike) close();
  return pieces;
}

double ByRest(const std::array<double, kOverhangDegrees>& values, double full, uint8_t rest) {
  const double place = static_cast<double>(rest) / kFullRest * kOverhangDegrees;
  const auto degree = std::min(static_cast<size_t>(place), values.size() - 1);
  const double next = degree + 1 < values.size() ? values[degree + 1] : full;
  return values[degree] + (place - static_cast<double>(degree)) * (next - values[degree]);
}

}  // namespace slicefarm::motion
