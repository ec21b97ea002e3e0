#include "services/infill/algo/lines/line_flow.h"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill {
namespace {

/// Cosine of the sharpest bend within a line.
constexpr double kLineBend = std::numbers::sqrt2 / 2;

/// Point of a path and the path's width there.
struct BeadPoint {
  Point at;
  Coord width_nm = 0;

  friend bool operator==(const BeadPoint&, const BeadPoint&) = default;
};

/// Returns the points of a path from end to end. A closed path starts and ends in the middle of its
/// longest edge.
std::vector<BeadPoint> BeadOf(const Path& path) {
  std::vector<BeadPoint> bead;
  for (size_t i = 0; i < path.points.size(); ++i) bead.push_back({path.points[i], path.WidthAt(i)});
  if (!path.closed) return bead;
  const auto length = [&](size_t i) {
    return Distance(bead[i].at, bead[(i + 1) % bead.size()].at);
  };
  size_t longest = 0;
  for (size_t i = 1; i < bead.size(); ++i)
    if (length(i) > length(longest)) longest = i;
  const BeadPoint& a = bead[longest];
  const BeadPoint& b = bead[(longest + 1) % bead.size()];
  const BeadPoint middle{{(a.at.x + b.at.x) / 2, (a.at.y + b.at.y) / 2},
                         (a.width_nm + b.width_nm) / 2};
  std::rotate(bead.begin(), bead.begin() + static_cast<int64_t>(longest) + 1, bead.end());
  bead.insert(bead.begin(), middle);
  bead.push_back(middle);
  return bead;
}

bool IsTurn(Point a, Point b) { return Dot(a, b) < kLineBend * Norm(a) * Norm(b); }

/// Returns, for each edge of the bead, the index of its line, from 0. A new line begins at each
/// turn.
std::vector<size_t> LinesOf(const std::vector<BeadPoint>& bead) {
  std::vector<size_t> lines;
  size_t line = 0;
  Point route;
  for (size_t i = 1; i < bead.size(); ++i) {
    const Point edge = bead[i].at - bead[i - 1].at;
    if (edge != Point{}) {
      if (route != Point{} && IsTurn(route, edge)) ++line;
      route = edge;
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<double> LengthsOf(const std::vector<BeadPoint>& bead, const std::vector<size_t>& lines,
                              bool closed) {
  std::vector<double> lengths_mm(lines.back() + 1, 0);
  for (size_t i = 0; i < lines.size(); ++i)
    lengths_mm[lines[i]] += ToMm(Distance(bead[i].at, bead[i + 1].at));
  if (closed && lengths_mm.size() > 1) lengths_mm.front() = lengths_mm.back() += lengths_mm.front();
  return lengths_mm;
}

void SetBead(const std::vector<BeadPoint>& bead, Path& path) {
  path.points.clear();
  path.widths_nm.clear();
  for (const auto& [at, width_nm] : bead) {
    path.points.push_back(at);
    path.widths_nm.push_back(width_nm);
  }
  const auto same = std::ranges::count(path.widths_nm, path.widths_nm[0]);
  if (same == std::ssize(path.widths_nm)) path.widths_nm.resize(1);
}

}  // namespace

Coord WidthFor(double share, Coord width_nm, Coord from_nm, Coord to_nm) {
  const double height_mm = ToMm(static_cast<double>(to_nm));
  return WidthToFill(FromMm(share * SectionMm2(width_nm, from_nm) / height_mm), to_nm);
}

void ThinShortLines(const FlowTable& table, Coord height_nm, Path& path) {
  const std::vector<BeadPoint> bead = BeadOf(path);
  const std::vector<size_t> lines = LinesOf(bead);
  std::vector<double> factors;
  for (const double length_mm : LengthsOf(bead, lines, path.closed))
    factors.push_back(FlowAt(table, length_mm));
  if (std::ranges::all_of(factors, [](double factor) { return factor == 1; })) return;
  std::vector<BeadPoint> thinned;
  const auto append = [&](size_t point, size_t edge) {
    const double factor = factors[lines[edge]];
    const Coord width = bead[point].width_nm;
    const BeadPoint next{
        bead[point].at,
        factor == 1 ? width : std::max<Coord>(1, WidthFor(factor, width, height_nm, height_nm))};
    if (thinned.empty() || thinned.back() != next) thinned.push_back(next);
  };
  for (size_t edge = 0; edge < lines.size(); ++edge) {
    append(edge, edge);
    append(edge + 1, edge);
  }
  if (path.closed) thinned.pop_back();
  SetBead(thinned, path);
}

}  // namespace slicefarm::infill
