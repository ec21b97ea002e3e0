#include "services/beading/algo/beads/thick_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::beading {
namespace {

Coord Mix(Coord a, Coord b, double t) { return a + std::llround(t * static_cast<double>(b - a)); }
Point Mix(Point a, Point b, double t) { return {Mix(a.x, b.x, t), Mix(a.y, b.y, t)}; }

/// Straight line between two points of a thick line, with linearly changing thickness.
class Chord {
 public:
  Chord(const ThickLine& line, size_t a, size_t b)
      : line_(line),
        a_(a),
        x_(static_cast<double>(line.points[b].x - line.points[a].x)),
        y_(static_cast<double>(line.points[b].y - line.points[a].y)),
        thicker_(static_cast<double>(line.thickness_nm[b] - line.thickness_nm[a])) {
    const double squared = x_ * x_ + y_ * y_;
    inverse_ = squared > 0 ? 1 / squared : 0;
  }

  /// Returns the square of a point's deviation from the chord, in position or in thickness.
  double SquaredDeviation(size_t i) const {
    const auto x = static_cast<double>(line_.points[i].x - line_.points[a_].x);
    const auto y = static_cast<double>(line_.points[i].y - line_.points[a_].y);
    const double t = std::clamp((x * x_ + y * y_) * inverse_, 0.0, 1.0);
    const double dx = x - t * x_, dy = y - t * y_;
    const auto thicker = static_cast<double>(line_.thickness_nm[i] - line_.thickness_nm[a_]);
    const double dt = thicker - t * thicker_;
    return std::max(dx * dx + dy * dy, dt * dt);
  }

 private:
  const ThickLine& line_;
  size_t a_;
  double x_, y_, thicker_, inverse_;
};

}  // namespace

double Length(const ThickLine& line) {
  double length = 0;
  for (size_t i = 1; i < line.points.size(); ++i)
    length += Distance(line.points[i - 1], line.points[i]);
  return line.closed ? length + Distance(line.points.back(), line.points.front()) : length;
}

double Area(const ThickLine& line) {
  double area = 0;
  const size_t count = line.points.size();
  for (size_t i = line.closed ? 0 : 1; i < count; ++i) {
    const size_t before = i == 0 ? count - 1 : i - 1;
    area += Distance(line.points[before], line.points[i]) *
            static_cast<double>(line.thickness_nm[before] + line.thickness_nm[i]) / 2;
  }
  return area;
}

void CutEnd(ThickLine& line, double length_nm) {
  while (line.points.size() >= 2) {
    const Point last = line.points.back(), before = line.points[line.points.size() - 2];
    const double edge = Distance(before, last);
    if (edge > length_nm) {
      const double t = length_nm / edge;
      line.points.back() = Mix(last, before, t);
      Coord& thickness = line.thickness_nm.back();
      thickness = Mix(thickness, line.thickness_nm[line.thickness_nm.size() - 2], t);
      return;
    }
    length_nm -= edge;
    line.points.pop_back();
    line.thickness_nm.pop_back();
  }
  line.points.clear();
  line.thickness_nm.clear();
}

void ExtendEnd(ThickLine& line, double length_nm) {
  const Point end = line.points.back();
  size_t from = line.points.size() - 1;
  while (from > 0 && Distance(line.points[from], end) < length_nm) --from;
  const double reach = Distance(line.points[from], end);
  if (reach == 0) return;
  line.points.push_back(Mix(end, end + (end - line.points[from]), length_nm / reach));
  line.thickness_nm.push_back(line.thickness_nm.back());
}

void Reverse(ThickLine& line) {
  std::reverse(line.points.begin(), line.points.end());
  std::reverse(line.thickness_nm.begin(), line.thickness_nm.end());
}

namespace {

/// Marks the points between two kept ones that a line needs to deviate by at most the tolerance.
void KeepNeeded(const ThickLine& line, size_t first, size_t last, Coord tolerance_nm,
                std::vector<bool>& keep) {
  std::vector<std::pair<size_t, size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const Chord chord(line, from, to);
    double worst = static_cast<double>(tolerance_nm) * static_cast<double>(tolerance_nm);
    size_t at = from;
    for (size_t i = from + 1; i < to; ++i) {
      const double deviation = chord.SquaredDeviation(i);
      if (deviation > worst) worst = deviation, at = i;
    }
    if (at == from) continue;
    keep[at] = true;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

ThickLine Kept(const ThickLine& line, const std::vector<bool>& keep) {
  ThickLine simple{line.closed, {}, {}};
  for (size_t i = 0; i < line.points.size(); ++i) {
    if (!keep[i]) continue;
    simple.points.push_back(line.points[i]);
    simple.thickness_nm.push_back(line.thickness_nm[i]);
  }
  return simple;
}

}  // namespace

ThickLine SimplifyThickLine(const ThickLine& line, Coord tolerance_nm) {
  if (line.points.size() < 3) return line;
  std::vector<bool> keep(line.points.size(), false);
  keep.front() = keep.back() = true;
  KeepNeeded(line, 0, line.points.size() - 1, tolerance_nm, keep);
  return Kept(line, keep);
}

ThickLine MergeShortEdges(const ThickLine& line, Coord least_nm, Coord tolerance_nm) {
  const size_t count = line.points.size();
  if (count < 3) return line;
  const auto is_short = [&](size_t i) {
    return Distance(line.points[i - 1], line.points[i]) < static_cast<double>(least_nm);
  };
  std::vector<bool> keep(count, false);
  keep.front() = keep.back() = true;
  for (size_t first = 0; first + 1 < count;) {
    size_t last = first + 1;
    for (keep[first] = true; last + 1 < count && is_short(last) && is_short(last + 1);) ++last;
    keep[last] = true;
    KeepNeeded(line, first, last, tolerance_nm, keep);
    first = last;
  }
  ThickLine merged = Kept(line, keep);
  return line.closed && merged.points.size() < 3 ? line : merged;
}

}  // namespace slicefarm::beading
