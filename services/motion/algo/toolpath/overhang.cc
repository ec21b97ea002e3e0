#include "services/motion/algo/toolpath/overhang.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

constexpr Coord kSquareNm = kNmPerMm / 2;
constexpr double kRestingPieceMm = 1;
/// A share of a nanometre that is no simple fraction.
constexpr double kAside = 0.3183;

/// Squared distance from a point to an edge, nm^2.
double SquaredDistance(Point p, Point from, Point to) {
  const double x = static_cast<double>(to.x - from.x), y = static_cast<double>(to.y - from.y);
  const double px = static_cast<double>(p.x - from.x), py = static_cast<double>(p.y - from.y);
  const double squared = x * x + y * y;
  const double along = squared > 0 ? std::clamp((px * x + py * y) / squared, 0.0, 1.0) : 0;
  const double dx = px - along * x, dy = py - along * y;
  return dx * dx + dy * dy;
}

/// Where the edge passes a height; nothing if it does not. Of its two ends one counts.
std::optional<double> XAt(double y, Point from, Point to) {
  const auto from_y = static_cast<double>(from.y), to_y = static_cast<double>(to.y);
  if ((from_y > y) == (to_y > y)) return std::nullopt;
  return static_cast<double>(from.x) +
         (y - from_y) / (to_y - from_y) * static_cast<double>(to.x - from.x);
}

/// The same with x and y in each other's place.
std::optional<double> YAt(double x, Point from, Point to) {
  return XAt(x, {from.y, from.x}, {to.y, to.x});
}

/// Where the line meets the edge, as a share of the line's length; -1: nowhere.
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

/// The middle of a square, aside of whole nanometres: no corner of an outline lies on lines through
/// it.
LayerBelow::Middle LayerBelow::MiddleOf(int32_t row, int32_t column) const {
  const auto square = static_cast<double>(edges_.square_nm());
  const Point least = edges_.bounds().min;
  return {static_cast<double>(least.x) + (column + 0.5) * square + kAside,
          static_cast<double>(least.y) + (row + 0.5) * square + kAside};
}

/// Counts what lies to the left of middles, row by row.
void LayerBelow::FindMiddlesInside() {
  const Box& box = edges_.bounds();
  columns_ = edges_.Column(box.max.x) + 1;
  const int32_t rows = edges_.Row(box.max.y) + 1;
  middle_inside_.assign(static_cast<size_t>(rows) * columns_, false);
  for (int32_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_.At(i);
    const int32_t last = edges_.Row(std::max(edge.a.y, edge.b.y));
    for (int32_t row = edges_.Row(std::min(edge.a.y, edge.b.y)); row <= last; ++row) {
      const auto x = XAt(MiddleOf(row, 0).y, edge.a, edge.b);
      if (!x) continue;
      int32_t column = edges_.Column(static_cast<Coord>(*x));
      if (MiddleOf(row, column).x < *x) ++column;
      if (column == columns_) continue;
      const auto square = static_cast<size_t>(row) * columns_ + column;
      middle_inside_[square] = !middle_inside_[square];
    }
  }
  for (size_t square = 1; square < middle_inside_.size(); ++square)
    if (square % columns_ != 0)
      middle_inside_[square] = middle_inside_[square] != middle_inside_[square - 1];
}

uint8_t LayerBelow::RestOf(Point point, Coord width_nm) const {
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
  const double share = 0.5 - out / static_cast<double>(width_nm);
  return static_cast<uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * kFullRest));
}

/// By what lies between the point and the middle of its square: upwards or downwards first, then
/// sideways.
bool LayerBelow::Covers(Point point) const {
  const Box& box = edges_.bounds();
  if (edges_.size() == 0 || point.x < box.min.x || point.x > box.max.x || point.y < box.min.y ||
      point.y > box.max.y)
    return false;
  const int32_t row = edges_.Row(point.y), column = edges_.Column(point.x);
  const Middle middle = MiddleOf(row, column);
  const double x = static_cast<double>(point.x) + kAside, y = static_cast<double>(point.y);
  bool inside = middle_inside_[static_cast<size_t>(row) * columns_ + column];
  edges_.ForEachNear({point, point}, [&](int32_t i) {
    const Edge& edge = edges_.At(i);
    if (const auto at = YAt(x, edge.a, edge.b); at && (*at > y) != (*at > middle.y))
      inside = !inside;
    if (const auto at = XAt(middle.y, edge.a, edge.b); at && (*at > x) != (*at > middle.x))
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
  // An edge is in all squares that it passes.
  std::ranges::sort(shares);
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  return shares;
}

int RestAlong::RestOf(Point point, Coord width_nm) {
  if (point != at_ || width_nm != width_nm_) {
    at_ = point;
    width_nm_ = width_nm;
    // What lies within the outlines rests by half at least, however near to their edge.
    const bool is_enough = steps_ == RestSteps::kAirAlone && below_.Covers(point);
    rest_ = is_enough ? kFullRest : below_.RestOf(point, width_nm);
  }
  return rest_;
}

std::vector<RestingPiece> RestAlong::PiecesOf(Point from, Point to, Coord width_nm) {
  const auto count =
      std::max<int64_t>(1, std::llround(std::ceil(ToMm(Distance(from, to)) / kRestingPieceMm)));
  std::vector<RestingPiece> pieces;
  int before = RestOf(from, width_nm);
  for (int64_t i = 1; i <= count; ++i) {
    const Point end = {from.x + (to.x - from.x) * i / count, from.y + (to.y - from.y) * i / count};
    const int at_end = RestOf(end, width_nm);
    auto rest = static_cast<uint8_t>((before + at_end) / 2);
    if (steps_ == RestSteps::kAirAlone && rest > 0) rest = kFullRest;
    before = at_end;
    if (!pieces.empty() && pieces.back().rest == rest) {
      pieces.back().to = end;
    } else {
      pieces.push_back({end, rest});
    }
  }
  return pieces;
}

double ByRest(const std::array<double, kOverhangDegrees>& told, double full, uint8_t rest) {
  const double place = static_cast<double>(rest) / kFullRest * kOverhangDegrees;
  const auto degree = std::min(static_cast<size_t>(place), told.size() - 1);
  const double next = degree + 1 < told.size() ? told[degree + 1] : full;
  return told[degree] + (place - static_cast<double>(degree)) * (next - told[degree]);
}

}  // namespace slicefarm::motion
