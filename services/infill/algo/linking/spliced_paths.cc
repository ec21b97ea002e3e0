#include "services/infill/algo/linking/spliced_paths.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "common/geometry/box_index.h"
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

/// Paths that take in rings, one after the other.
class Splicer {
 public:
  Splicer(std::vector<Path> paths, double margin_nm)
      : margin_nm_(margin_nm), index_(BoxesOf(paths)), owner_(paths.size()) {
    std::iota(owner_.begin(), owner_.end(), size_t{0});
    placed_.reserve(paths.size());
    for (Path& path : paths) {
      const Box box = Bounds(path.points);
      placed_.push_back({std::move(path), box});
    }
  }

  std::vector<Path> Run() {
    for (size_t ring = placed_.size(); ring-- > 0 && pairs_ < kMostPairs;)
      if (placed_[ring].path.closed) TakeInto(ring);
    std::vector<Path> paths;
    for (size_t i = 0; i < placed_.size(); ++i)
      if (owner_[i] == i) paths.push_back(std::move(placed_[i].path));
    return paths;
  }

 private:
  static std::vector<Box> BoxesOf(const std::vector<Path>& paths) {
    std::vector<Box> boxes;
    boxes.reserve(paths.size());
    for (const Path& path : paths) boxes.push_back(Bounds(path.points));
    return boxes;
  }

  /// Returns the path that has taken in a path, directly or with another one.
  size_t OwnerOf(size_t path) {
    for (; owner_[path] != path; path = owner_[path]) owner_[path] = owner_[owner_[path]];
    return path;
  }

  /// Returns the other paths with parts near a ring, ascending.
  std::vector<size_t> PathsNear(size_t ring) {
    std::vector<size_t> near = index_.Meeting(placed_[ring].box);
    for (size_t& path : near) path = OwnerOf(path);
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase(near, ring);
    return near;
  }

  /// Inserts a ring into the first other path that it crosses, if there is one.
  void TakeInto(size_t ring) {
    for (const size_t i : PathsNear(ring)) {
      if (pairs_ >= kMostPairs) return;
      const auto crossing = FirstCrossing(placed_[i], placed_[ring].path, margin_nm_, pairs_);
      if (!crossing) continue;
      TakeIn(placed_[ring].path, *crossing, kCut * margin_nm_, placed_[i].path);
      placed_[i].box.Add(placed_[ring].box);
      owner_[ring] = i;
      return;
    }
  }

  const double margin_nm_;
  const BoxIndex index_;       ///< boxes of the paths as they were given
  std::vector<size_t> owner_;  ///< path that has taken in each path; else the path itself
  std::vector<Placed> placed_;
  size_t pairs_ = 0;  ///< number of compared pairs of segments
};

}  // namespace

std::vector<Path> SplicedPaths(std::vector<Path> paths, double margin_nm) {
  return Splicer(std::move(paths), margin_nm).Run();
}

}  // namespace slicefarm::infill
