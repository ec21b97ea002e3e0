#include "services/exposure/algo/scan/border_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicefarm::exposure {
namespace {

/// smallest square_bits_: a square is at least 2^16 nm = 65 um wide
constexpr int kLeastBits = 16;
constexpr double kSquaresPerEdge = 4;
constexpr double kLeastSquares = 1024;
/// Largest error of a position by rounding, in nm.
constexpr double kRounding = 1;

double SquaredDistance(Vector2 p, Vector2 a, Vector2 b) {
  const Vector2 path = b - a, at = p - a;
  const double length2 = Dot(path, path);
  const double t = length2 > 0 ? std::clamp(Dot(at, path) / length2, 0.0, 1.0) : 0;
  const Vector2 off{at.x() - t * path.x(), at.y() - t * path.y()};
  return Dot(off, off);
}

bool DoCross(Vector2 a, Vector2 b, Vector2 c, Vector2 d) {
  const double ab_c = Cross(b - a, c - a), ab_d = Cross(b - a, d - a);
  const double cd_a = Cross(d - c, a - c), cd_b = Cross(d - c, b - c);
  return (ab_c < 0) != (ab_d < 0) && (cd_a < 0) != (cd_b < 0);
}

/// Returns true if two segments are at least `distance` apart.
bool AreApart(Vector2 a, Vector2 b, Vector2 c, Vector2 d, double distance) {
  const double nearest = std::min({SquaredDistance(a, c, d), SquaredDistance(b, c, d),
                                   SquaredDistance(c, a, b), SquaredDistance(d, a, b)});
  return nearest >= distance * distance && !DoCross(a, b, c, d);
}

using Span = std::pair<double, double>;

/// Extends `span` by the values of t at which `a + t * path` is within `distance` of the point
/// c.
void AddCircle(Vector2 a, Vector2 path, Vector2 c, double distance, Span& span) {
  const double length2 = Dot(path, path), along = Dot(c - a, path) / length2;
  const Vector2 off{a.x() + along * path.x() - c.x(), a.y() + along * path.y() - c.y()};
  const double half2 = (distance * distance - Dot(off, off)) / length2;
  if (half2 < 0) return;
  const double half = std::sqrt(half2);
  span = {std::min(span.first, along - half), std::max(span.second, along + half)};
}

/// Extends `span` by the values of t at which `a + t * path` is in the rectangle that reaches
/// `distance` to both sides of the segment cd.
void AddRectangle(Vector2 a, Vector2 path, Vector2 c, Vector2 d, double distance, Span& span) {
  const double length = Norm(d - c);
  if (!(length > 0)) return;
  const Vector2 unit{(d.x() - c.x()) / length, (d.y() - c.y()) / length};
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  const auto clip = [&](double at, double speed, double least, double most) {
    if (speed == 0) {
      if (at < least || at > most) high = -std::numeric_limits<double>::infinity();
      return;
    }
    const double t = (least - at) / speed, u = (most - at) / speed;
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
  };
  clip(Dot(a - c, unit), Dot(path, unit), 0, length);
  clip(Cross(unit, a - c), Cross(unit, path), -distance, distance);
  if (low > high) return;
  span = {std::min(span.first, low), std::max(span.second, high)};
}

/// Returns the values of t at which `a + t * path` is within `distance` of the segment cd. If
/// first > second, there is no such value.
Span NearSpan(Vector2 a, Vector2 path, Vector2 c, Vector2 d, double distance) {
  Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  AddCircle(a, path, c, distance, span);
  AddCircle(a, path, d, distance, span);
  AddRectangle(a, path, c, d, distance, span);
  return span;
}

/// Returns the longest part of [0, 1] outside of all spans. Sorts the spans.
Span LongestGap(std::vector<Span>& spans) {
  std::sort(spans.begin(), spans.end());
  Span best{0, 0};
  double at = 0;
  for (const Span& span : spans) {
    if (const double end = std::min(span.first, 1.0); end - at > best.second - best.first)
      best = {at, end};
    at = std::max(at, span.second);
  }
  if (1 - at > best.second - best.first) best = {at, 1};
  return best;
}

/// Returns true if `holds(t)` is true in the middle of each part of [0, 1] outside of all spans.
/// Sorts the spans.
template <typename Holds>
bool AllGaps(std::vector<Span>& spans, Holds holds) {
  std::sort(spans.begin(), spans.end());
  double at = 0;
  for (const Span& span : spans) {
    if (span.first > at && !holds((at + std::min(span.first, 1.0)) / 2)) return false;
    at = std::max(at, span.second);
    if (at >= 1) return true;
  }
  return holds((at + 1) / 2);
}

}  // namespace

BorderGrid::BorderGrid(const MultiPolygon& region, double reach_nm) : box_(Bounds(region)) {
  if (box_.Empty()) return;
  edges_.reserve(PointCount(region));
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vector2 a = Local(ring[i]), b = Local(ring[i + 1 == ring.size() ? 0 : i + 1]);
      const Vector2 path = b - a;
      const double length = Norm(path);
      const Vector2 inward{-path.y() / length, path.x() / length};
      if (length > 0) edges_.push_back({inward, Dot(inward, a), a, b});
    }
  });
  ChooseSquares(reach_nm);
  SortEdges(reach_nm);
  FindInterior();
}

void BorderGrid::ChooseSquares(double reach_nm) {
  const double width = static_cast<double>(box_.max.x - box_.min.x) + 1;
  const double height = static_cast<double>(box_.max.y - box_.min.y) + 1;
  const double most = std::max(kLeastSquares, kSquaresPerEdge * static_cast<double>(edges_.size()));
  square_bits_ = kLeastBits;
  const auto is_fine = [&] {
    square_ = std::ldexp(1, square_bits_);
    return square_ >= reach_nm / 2 && (width / square_ + 1) * (height / square_ + 1) <=
                                          most + width / square_ + height / square_;
  };
  while (!is_fine()) ++square_bits_;
  per_nm_ = 1 / square_;
  columns_ = static_cast<int32_t>((box_.max.x - box_.min.x) >> square_bits_) + 1;
  rows_ = static_cast<int32_t>((box_.max.y - box_.min.y) >> square_bits_) + 1;
}

template <typename Visit>
void BorderGrid::ForEachSquare(const Edge& edge, double reach_nm, Visit visit) const {
  const double reach = reach_nm + kRounding;
  const Vector2 low = edge.a.y() < edge.b.y() ? edge.a : edge.b;
  const Vector2 high = edge.a.y() < edge.b.y() ? edge.b : edge.a;
  const int32_t bottom = At({0, low.y() - reach}).row, top = At({0, high.y() + reach}).row;
  for (int32_t row = bottom; row <= top; ++row) {
    // Part of the edge, from t0 to t1, that is within reach of the row.
    double t0 = 0, t1 = 1;
    if (high.y() > low.y()) {
      t0 = std::clamp((row * square_ - reach - low.y()) / (high.y() - low.y()), 0.0, 1.0);
      t1 = std::clamp(((row + 1) * square_ + reach - low.y()) / (high.y() - low.y()), 0.0, 1.0);
    }
    const double x0 = low.x() + t0 * (high.x() - low.x()), x1 = low.x() + t1 * (high.x() - low.x());
    const int32_t left = At({std::min(x0, x1) - reach, 0}).column;
    const int32_t right = At({std::max(x0, x1) + reach, 0}).column;
    for (int32_t column = left; column <= right; ++column) visit(IndexOf({column, row}));
  }
}

void BorderGrid::SortEdges(double reach_nm) {
  begin_.assign(static_cast<size_t>(columns_) * rows_ + 1, 0);
  for (const Edge& edge : edges_)
    ForEachSquare(edge, reach_nm, [&](size_t square) { ++begin_[square + 1]; });
  for (size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  items_.resize(static_cast<size_t>(begin_.back()));
  std::vector<int32_t> next(begin_.begin(), begin_.end() - 1);
  for (size_t i = 0; i < edges_.size(); ++i) {
    ForEachSquare(edges_[i], reach_nm, [&](size_t square) {
      items_[static_cast<size_t>(next[square]++)] = static_cast<int32_t>(i);
    });
  }
}

void BorderGrid::FindInterior() {
  // A square without border is inside if a ray from the left to its middle crosses the border an
  // odd number of times.
  interior_.assign(static_cast<size_t>(columns_) * rows_, 0);
  for (const Edge& edge : edges_) {
    const double low = std::min(edge.a.y(), edge.b.y()), high = std::max(edge.a.y(), edge.b.y());
    for (int32_t row = At({0, low}).row; row <= At({0, high}).row; ++row) {
      const double y = (row + 0.5) * square_;
      if ((edge.a.y() <= y) == (edge.b.y() <= y)) continue;
      const double t = (y - edge.a.y()) / (edge.b.y() - edge.a.y());
      interior_[IndexOf(At({edge.a.x() + t * (edge.b.x() - edge.a.x()), y}))] ^= 1;
    }
  }
  for (int32_t row = 0; row < rows_; ++row) {
    uint8_t odd = 0;
    for (int32_t column = 0; column < columns_; ++column) {
      const size_t i = IndexOf({column, row});
      odd ^= interior_[i];
      interior_[i] = begin_[i] == begin_[i + 1] ? odd : 0;
    }
  }
  // Computes each square's distance to the nearest square with boundary or outside, from the
  // distances of its neighbours. One pass forward and one pass backward over the grid are enough.
  const auto relax = [&](int32_t column, int32_t row, int32_t step) {
    uint8_t& distance = interior_[IndexOf({column, row})];
    if (distance == 0) return;
    const auto at = [&](int32_t c, int32_t r) -> int {
      return c < 0 || r < 0 || c >= columns_ || r >= rows_ ? 0 : interior_[IndexOf({c, r})];
    };
    const int least = std::min({at(column - step, row), at(column - step, row - step),
                                at(column, row - step), at(column + step, row - step)});
    const int most = step > 0 ? 254 : distance - 1;
    distance = static_cast<uint8_t>(1 + std::min(least, most));
  };
  for (int32_t row = 0; row < rows_; ++row)
    for (int32_t column = 0; column < columns_; ++column) relax(column, row, 1);
  for (int32_t row = rows_ - 1; row >= 0; --row)
    for (int32_t column = columns_ - 1; column >= 0; --column) relax(column, row, -1);
}

bool BorderGrid::IsFarFromBorder(Point a, Point b) const {
  const Square middle = SquareOf({(a.x + b.x) / 2, (a.y + b.y) / 2});
  const int32_t distance = interior_[IndexOf(middle)];
  const auto is_inside = [&](Square s) {
    return std::abs(s.column - middle.column) < distance && std::abs(s.row - middle.row) < distance;
  };
  return is_inside(SquareOf(a)) && is_inside(SquareOf(b));
}

bool BorderGrid::Keeps(Point a, Point b, double distance_nm) const {
  if (!Has(a) || !Has(b)) return false;
  if (IsFarFromBorder(a, b)) return true;
  const Vector2 from = Local(a), to = Local(b);
  bool inside = false;
  return KeepsAlong(from, to, distance_nm, inside) &&
         (inside || IsInside({(from.x() + to.x()) / 2, (from.y() + to.y()) / 2}));
}

bool BorderGrid::KeepsOn(Point a, Point b, double distance_nm) const {
  if (!Has(a) || !Has(b)) return false;
  bool inside = true;
  return IsFarFromBorder(a, b) || KeepsAlong(Local(a), Local(b), distance_nm, inside);
}

bool BorderGrid::Stays(Point a, Point b, double beyond_nm) const {
  if (Has(a) && Has(b) && IsFarFromBorder(a, b)) return true;
  const Box around = box_.Grown(static_cast<Coord>(beyond_nm));
  const auto may_stay = [&](Point p) {
    return p.x >= around.min.x && p.x <= around.max.x && p.y >= around.min.y && p.y <= around.max.y;
  };
  return !box_.Empty() && may_stay(a) && may_stay(b) &&
         IsInsideWhereFar(Local(a), Local(b), beyond_nm);
}

/// Returns true if an edge is beside the whole segment ab, at most `distance_nm` away. This is true
/// for contours on the outline.
bool BorderGrid::RunsAlongEdge(Vector2 a, Vector2 b, double distance_nm) const {
  const size_t square = IndexOf(At(a));
  const auto is_beside = [&](const Edge& edge, Vector2 p) {
    return std::abs(edge.LeftOf(p)) <= distance_nm && Cross(p - edge.a, edge.inward) >= -1 &&
           Cross(p - edge.b, edge.inward) <= 1;
  };
  return std::any_of(items_.begin() + begin_[square], items_.begin() + begin_[square + 1],
                     [&](int32_t i) {
                       const Edge& edge = edges_[static_cast<size_t>(i)];
                       return is_beside(edge, a) && is_beside(edge, b);
                     });
}

bool BorderGrid::IsInsideButEnds(Vector2 a, Vector2 b, double ends_nm) const {
  const Vector2 path = b - a;
  const double length = Norm(path);
  if (length <= 2 * ends_nm) return false;
  const Vector2 end{path.x() * (ends_nm / length), path.y() * (ends_nm / length)};
  const Vector2 from{a.x() + end.x(), a.y() + end.y()}, to = b - end;
  const auto crosses_none = [&](size_t square) {
    return std::none_of(items_.begin() + begin_[square], items_.begin() + begin_[square + 1],
                        [&](int32_t i) {
                          const Edge& edge = edges_[static_cast<size_t>(i)];
                          return (edge.LeftOf(from) > 0) != (edge.LeftOf(to) > 0) &&
                                 DoCross(from, to, edge.a, edge.b);
                        });
  };
  return Follow(from, to, crosses_none) &&
         IsInside({(from.x() + to.x()) / 2, (from.y() + to.y()) / 2});
}

/// Tests the parts of the segment that are far from the boundary. Such a part does not cross the
/// boundary, so it is inside if its middle is inside.
bool BorderGrid::IsInsideWhereFar(Vector2 a, Vector2 b, double distance_nm) const {
  if (RunsAlongEdge(a, b, distance_nm) || IsInsideButEnds(a, b, distance_nm)) return true;
  const Vector2 path = b - a;
  if (!(Dot(path, path) > 0)) return IsInside(a) || IsNearEdge(a, distance_nm);
  std::vector<Span> near;
  Follow(a, b, [&](size_t square) {
    for (int32_t i = begin_[square]; i < begin_[square + 1]; ++i) {
      const Edge& edge = edges_[static_cast<size_t>(items_[static_cast<size_t>(i)])];
      const double left_a = edge.LeftOf(a), left_b = edge.LeftOf(b);
      if (std::min(left_a, left_b) > distance_nm || std::max(left_a, left_b) < -distance_nm ||
          edge.AreBeside(a, b, distance_nm))
        continue;
      const Span span = NearSpan(a, path, edge.a, edge.b, distance_nm);
      if (span.first <= span.second) near.push_back(span);
    }
    return true;
  });
  return AllGaps(near, [&](double t) {
    return IsInside({a.x() + t * path.x(), a.y() + t * path.y()});
  });
}

/// Calls visit(square) for the squares that a segment passes, until visit returns false. Skips
/// squares far from the boundary. Returns true if visit never returned false.
template <typename Visit>
bool BorderGrid::Follow(Vector2 a, Vector2 b, Visit visit) const {
  const Vector2 path = b - a;
  const Vector2 per_path{1 / path.x(), 1 / path.y()};  // infinite: never leaves on this axis
  const double jump = square_ / std::max(std::abs(path.x()), std::abs(path.y()));
  const int32_t ahead_x = path.x() >= 0 ? 1 : 0, ahead_y = path.y() >= 0 ? 1 : 0;
  const Square end = At(b);
  for (Square at = At(a);;) {
    const size_t index = IndexOf(at);
    if (!visit(index)) return false;
    if (at.column == end.column && at.row == end.row) return true;
    const double next_x = ((at.column + ahead_x) * square_ - a.x()) * per_path.x();
    const double next_y = ((at.row + ahead_y) * square_ - a.y()) * per_path.y();
    const bool leaves_aside = !(next_y <= next_x);
    const double next = leaves_aside ? next_x : next_y;
    if (!(next < 1)) return true;
    if (interior_[index] > 1) {  // jump to the end of the known free area
      const double far = next + (interior_[index] - 1) * jump;
      if (!(far < 1)) return true;
      at = At({a.x() + far * path.x(), a.y() + far * path.y()});
    } else if (leaves_aside) {
      at.column += 2 * ahead_x - 1;
      if (at.column < 0 || at.column >= columns_) return true;
    } else {
      at.row += 2 * ahead_y - 1;
      if (at.row < 0 || at.row >= rows_) return true;
    }
  }
}

bool BorderGrid::KeepsAlong(Vector2 a, Vector2 b, double distance_nm, bool& inside) const {
  const bool touches = distance_nm <= 0;
  return Follow(a, b, [&](size_t square) {
    const int32_t begin = begin_[square], end = begin_[square + 1];
    if (begin == end) {
      inside = inside || interior_[square] > 0;
      return interior_[square] > 0;
    }
    bool left_of_all = true;
    for (int32_t i = begin; i < end; ++i) {
      const Edge& edge = edges_[static_cast<size_t>(items_[static_cast<size_t>(i)])];
      const double left = std::min(edge.LeftOf(a), edge.LeftOf(b));
      if (left >= distance_nm) continue;
      left_of_all = false;
      if (edge.AreBeside(a, b, distance_nm)) continue;
      if (!AreApart(a, b, edge.a, edge.b, distance_nm)) return false;
    }
    inside = inside || (left_of_all && !touches);
    return true;
  });
}

bool BorderGrid::IsInside(Vector2 p) const {
  const int32_t row = At(p).row;
  bool odd = false;
  for (int32_t column = At(p).column; column >= 0; --column) {
    const size_t square = IndexOf({column, row});
    if (begin_[square] == begin_[square + 1]) return odd != (interior_[square] > 0);
    for (int32_t i = begin_[square]; i < begin_[square + 1]; ++i) {
      const Edge& edge = edges_[static_cast<size_t>(items_[static_cast<size_t>(i)])];
      if ((edge.a.y() <= p.y()) == (edge.b.y() <= p.y())) continue;
      const double t = (p.y() - edge.a.y()) / (edge.b.y() - edge.a.y());
      const Vector2 at{edge.a.x() + t * (edge.b.x() - edge.a.x()), p.y()};
      if (at.x() < p.x() && At(at).column == column) odd = !odd;
    }
  }
  return odd;
}

bool BorderGrid::IsNear(Point p, double distance_nm) const {
  return !edges_.empty() && IsNearEdge(Local(p), distance_nm);
}

bool BorderGrid::IsNearEdge(Vector2 at, double distance_nm) const {
  const size_t square = IndexOf(At(at));
  return std::any_of(items_.begin() + begin_[square], items_.begin() + begin_[square + 1],
                     [&](int32_t i) {
                       const Edge& edge = edges_[static_cast<size_t>(i)];
                       return SquaredDistance(at, edge.a, edge.b) < distance_nm * distance_nm;
                     });
}

std::optional<std::pair<Point, Point>> BorderGrid::LongestRun(Point a, Point b,
                                                              double distance_nm) const {
  if (!Has(a) || !Has(b) || a == b) return std::nullopt;
  const Vector2 from = Local(a), to = Local(b), path = to - from;
  std::vector<Span> spans;
  Follow(from, to, [&](size_t square) {
    for (int32_t i = begin_[square]; i < begin_[square + 1]; ++i) {
      const Edge& edge = edges_[static_cast<size_t>(items_[static_cast<size_t>(i)])];
      spans.push_back(NearSpan(from, path, edge.a, edge.b, distance_nm));
    }
    return true;
  });
  const auto place = [&](double t) {
    return Point{a.x + std::llround(t * path.x()), a.y + std::llround(t * path.y())};
  };
  const Span gap = LongestGap(spans);
  const std::pair run{place(gap.first), place(gap.second)};
  if (run.first == run.second || !Keeps(run.first, run.second, std::max(0.0, distance_nm - 2)))
    return std::nullopt;
  return run;
}

}  // namespace slicefarm::exposure
