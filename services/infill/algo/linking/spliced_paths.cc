#include "services/infill/algo/linking/spliced_paths.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/geometry/measure.h"

namespace slicefarm::infill {
namespace {

/// Largest number of pairs of segments that are compared.
constexpr size_t kMostPairs = 4'000'000;
/// Length cut off from a corner, as a share of the margin.
constexpr double kCut = 0.45;

/// Crossing of segment i of a path (from its point i) and segment j of another path.
struct PathCrossing {
  size_t i = 0;
  size_t j = 0;
  Point at;
};

size_t SpanCount(const Path& path) {
  return path.closed ? path.points.size() : path.points.size() - 1;
}

Point EndOfSpan(const Path& path, size_t i) {
  return path.points[i + 1 == path.points.size() ? 0 : i + 1];
}

/// Returns the point where ab and cd cross, if it is at least `margin` from their ends.
std::optional<Point> MeetingOf(Point a, Point b, Point c, Point d, double margin) {
  const auto x = [](Point p) { return static_cast<double>(p.x); };
  const auto y = [](Point p) { return static_cast<double>(p.y); };
  const Point u = b - a, v = d - c, w = c - a;
  const double det = x(u) * y(v) - y(u) * x(v);
  if (det == 0) return std::nullopt;
  const double s = (x(w) * y(v) - y(w) * x(v)) / det, t = (x(w) * y(u) - y(w) * x(u)) / det;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  const double along = Distance(a, b), across = Distance(c, d);
  const auto is_inside = [margin](double share, double length) {
    return share * length >= margin && (1 - share) * length >= margin;
  };
  if (!is_inside(s, along) || !is_inside(t, across)) return std::nullopt;
  return Point{a.x + std::llround(s * x(u)), a.y + std::llround(s * y(u))};
}

Box BoxOf(Point a, Point b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// Returns true if the segment's bounding box does not overlap `box`.
bool IsBeside(Point a, Point b, const Box& box) {
  return std::max(a.x, b.x) < box.min.x || std::min(a.x, b.x) > box.max.x ||
         std::max(a.y, b.y) < box.min.y || std::min(a.y, b.y) > box.max.y;
}

/// Path with its bounding box.
struct Placed {
  Path path;
  Box box;
};

std::optional<PathCrossing> FirstCrossing(const Placed& placed, const Path& ring, double margin,
                                          size_t& pairs) {
  const Path& path = placed.path;
  for (size_t j = 0; j < SpanCount(ring); ++j) {
    const Point c = ring.points[j], d = EndOfSpan(ring, j);
    const Box box = BoxOf(c, d);
    if (!box.Intersects(placed.box) || Distance(c, d) < 2 * margin) continue;
    pairs += SpanCount(path);
    for (size_t i = 0; i < SpanCount(path); ++i) {
      const Point a = path.points[i], b = EndOfSpan(path, i);
      if (IsBeside(a, b, box)) continue;
      if (auto at = MeetingOf(a, b, c, d, margin)) return PathCrossing{i, j, *at};
    }
  }
  return std::nullopt;
}

/// Returns the point at `distance_nm` from `at` in the direction of `to`.
Point OnTheWay(Point at, Point to, double distance_nm) {
  const double share = distance_nm / Distance(at, to);
  return {at.x + std::llround(share * static_cast<double>(to.x - at.x)),
          at.y + std::llround(share * static_cast<double>(to.y - at.y))};
}

/// Inserts a ring into a path at a crossing. The two corners there are cut off, so that the beads
/// on both sides of the crossing do not meet.
void TakeIn(const Path& ring, const PathCrossing& crossing, double cut_nm, Path& path) {
  const auto turn = [&](Point from, Point to, std::vector<Point>& points) {
    points.push_back(OnTheWay(crossing.at, from, cut_nm));
    points.push_back(OnTheWay(crossing.at, to, cut_nm));
  };
  std::vector<Point> points;
  turn(path.points[crossing.i], EndOfSpan(ring, crossing.j), points);
  for (size_t k = 1; k <= ring.points.size(); ++k)
    points.push_back(ring.points[(crossing.j + k) % ring.points.size()]);
  turn(ring.points[crossing.j], EndOfSpan(path, crossing.i), points);
  path.points.insert(path.points.begin() + static_cast<ptrdiff_t>(crossing.i + 1), points.begin(),
                     points.end());
}

/// Inserts a ring into the first other path that it crosses. Returns false if there is none.
bool IsTakenIn(size_t ring, double margin, std::vector<Placed>& paths, size_t& pairs) {
  for (size_t i = 0; i < paths.size() && pairs < kMostPairs; ++i) {
    if (i == ring || !paths[i].box.Intersects(paths[ring].box)) continue;
    const auto crossing = FirstCrossing(paths[i], paths[ring].path, margin, pairs);
    if (!crossing) continue;
    TakeIn(paths[ring].path, *crossing, kCut * margin, paths[i].path);
    paths[i].box.Add(paths[ring].box);
    return true;
  }
  return false;
}

}  // namespace

std::vector<Path> SplicedPaths(std::vector<Path> paths, double margin_nm) {
  std::vector<Placed> placed;
  placed.reserve(paths.size());
  for (Path& path : paths) {
    const Box box = Bounds(path.points);
    placed.push_back({std::move(path), box});
  }
  size_t pairs = 0;
  for (size_t ring = placed.size(); ring-- > 0 && pairs < kMostPairs;) {
    if (placed[ring].path.closed && IsTakenIn(ring, margin_nm, placed, pairs))
      placed.erase(placed.begin() + static_cast<ptrdiff_t>(ring));
  }
  paths.clear();
  for (Placed& one : placed) paths.push_back(std::move(one.path));
  return paths;
}

}  // namespace slicefarm::infill
