#include "services/motion/algo/toolpath/overhang.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

constexpr Coord kRowNm = kNmPerMm;
constexpr double kRestingPieceMm = 1;

/// Squared distance from a point to an edge, nm^2.
double SquaredDistance(Point p, Point from, Point to) {
  const double x = static_cast<double>(to.x - from.x), y = static_cast<double>(to.y - from.y);
  const double px = static_cast<double>(p.x - from.x), py = static_cast<double>(p.y - from.y);
  const double squared = x * x + y * y;
  const double along = squared > 0 ? std::clamp((px * x + py * y) / squared, 0.0, 1.0) : 0;
  const double dx = px - along * x, dy = py - along * y;
  return dx * dx + dy * dy;
}

/// Whether a ray from the point to the right crosses the edge.
bool Crosses(Point p, Point from, Point to) {
  if ((from.y > p.y) == (to.y > p.y)) return false;
  const double share = static_cast<double>(p.y - from.y) / static_cast<double>(to.y - from.y);
  return static_cast<double>(p.x) <
         static_cast<double>(from.x) + share * static_cast<double>(to.x - from.x);
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

LayerBelow::LayerBelow(const MultiPolygon& outlines) {
  Box bounds;
  for (const PolygonWithHoles& island : outlines) bounds.Add(Bounds(island.outer));
  if (bounds.Empty()) return;
  bottom_nm_ = bounds.min.y;
  rows_.resize(static_cast<size_t>((bounds.max.y - bottom_nm_) / kRowNm) + 1);
  const auto add = [this](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point from = ring[i], to = ring[i + 1 == ring.size() ? 0 : i + 1];
      const Edge edge = {from, to, std::min(from.x, to.x), std::max(from.x, to.x)};
      const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
      for (size_t row = RowOf(low); row <= RowOf(high); ++row) rows_[row].push_back(edge);
    }
  };
  for (const PolygonWithHoles& island : outlines) {
    add(island.outer);
    for (const Polygon& hole : island.holes) add(hole);
  }
}

size_t LayerBelow::RowOf(Coord y) const {
  const Coord row = (y - bottom_nm_) / kRowNm;
  return static_cast<size_t>(std::clamp<Coord>(row, 0, std::ssize(rows_) - 1));
}

uint8_t LayerBelow::RestOf(Point point, Coord width_nm) const {
  if (rows_.empty()) return 0;
  const Coord reach = width_nm / 2;
  double nearest = static_cast<double>(reach) * static_cast<double>(reach);
  for (size_t row = RowOf(point.y - reach); row <= RowOf(point.y + reach); ++row)
    for (const Edge& edge : rows_[row])
      if (edge.left <= point.x + reach && edge.right >= point.x - reach)
        nearest = std::min(nearest, SquaredDistance(point, edge.from, edge.to));
  const double out = std::sqrt(nearest) * (Covers(point) ? -1 : 1);
  const double share = 0.5 - out / static_cast<double>(width_nm);
  return static_cast<uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * kFullRest));
}

bool LayerBelow::Covers(Point point) const {
  const Coord top_nm = bottom_nm_ + std::ssize(rows_) * kRowNm;
  if (rows_.empty() || point.y < bottom_nm_ || point.y >= top_nm) return false;
  bool inside = false;
  for (const Edge& edge : rows_[RowOf(point.y)])
    if (Crosses(point, edge.from, edge.to)) inside = !inside;
  return inside;
}

std::vector<double> LayerBelow::EdgesOn(Point from, Point to) const {
  std::vector<double> shares;
  if (rows_.empty()) return shares;
  const auto [low, high] = std::minmax(from.y, to.y);
  for (size_t row = RowOf(low); row <= RowOf(high); ++row)
    for (const Edge& edge : rows_[row])
      if (const double share = Meeting(from, to, edge.from, edge.to); share >= 0)
        shares.push_back(share);
  // An edge is in all rows that it passes through.
  std::ranges::sort(shares);
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  return shares;
}

int RestAlong::RestOf(Point point, Coord width_nm) {
  if (point != at_ || width_nm != width_nm_) {
    at_ = point;
    width_nm_ = width_nm;
    rest_ = below_.RestOf(point, width_nm);
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
