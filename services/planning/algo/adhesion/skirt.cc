#include "services/planning/algo/adhesion/skirt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/between.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/box_index.h"
#include "common/geometry/convex.h"
#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/model/bead_section.h"
#include "common/model/limits.h"

namespace slicefarm::planning {
namespace {

Path SkirtLoop(Polygon ring, const SkirtOptions& options) {
  Path path;
  path.feature = Feature::kSkirt;
  path.closed = true;
  path.points = std::move(ring);
  path.widths_nm = {options.width_nm};
  return path;
}

/// Returns a ring that begins where the ray from `middle` at an angle leaves it. A ring that the
/// ray does not meet is not changed. REQUIRES: `middle` is inside the ring, which is convex.
Polygon BeginningAt(Polygon ring, Point middle, double angle_rad) {
  const double x = Cos(angle_rad), y = Sin(angle_rad);
  const auto side = [&](Point p) {
    const Point from = p - middle;
    return x * static_cast<double>(from.y) - y * static_cast<double>(from.x);
  };
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double before = side(a), after = side(b);
    if (!(before < 0 && after >= 0)) continue;  // the ring is counter-clockwise
    const Point start = PointBetween(a, b, before / (before - after));
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, ring.end());
    if (ring.front() != start && ring.back() != start) ring.insert(ring.begin(), start);
    return ring;
  }
  return ring;
}

/// Returns the length of filament that a loop uses on the first layer, in nm.
double FilamentNm(const Path& loop, const SkirtOptions& options) {
  return PathLength(loop) * SectionMm2(options.width_nm, options.height_nm) /
         options.filament_area_mm2;
}

/// Returns the positions where a segment crosses the bed's edge, ascending. Position 0 is the start
/// and 1 the end of the segment.
std::vector<double> Crossings(Point a, Point b, const MultiPolygon& bed) {
  std::vector<double> at;
  const Point along = b - a;
  for (const Polygon& ring : Rings(bed)) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point from = ring[i], edge = ring[(i + 1) % ring.size()] - from;
      const double cross = Cross(along, edge);
      if (cross == 0) continue;
      const double t = Cross(from - a, edge) / cross, u = Cross(from - a, along) / cross;
      if (0 < t && t < 1 && 0 <= u && u <= 1) at.push_back(t);
    }
  }
  std::ranges::sort(at);
  return at;
}

/// Collects the pieces of a line that are inside a region.
class LineClipper {
 public:
  explicit LineClipper(const MultiPolygon& region) : region_(region) {}

  void Add(Point a, Point b) {
    std::vector<double> at = Crossings(a, b, region_);
    at.push_back(1);
    double from = 0;
    for (const double to : at) {
      AddPiece(PointBetween(a, b, from), PointBetween(a, b, to),
               PointBetween(a, b, (from + to) / 2));
      from = to;
    }
  }

  /// Returns the pieces of a closed line. The last piece is joined with the first one if they
  /// touch.
  std::vector<Polyline> TakePieces() {
    if (pieces_.size() > 1 && pieces_.back().back() == pieces_.front().front()) {
      pieces_.back().insert(pieces_.back().end(), pieces_.front().begin() + 1,
                            pieces_.front().end());
      pieces_.erase(pieces_.begin());
    }
    return std::move(pieces_);
  }

 private:
  void AddPiece(Point a, Point b, Point middle) {
    if (a == b || !Covers(region_, middle)) return;
    if (pieces_.empty() || pieces_.back().back() != a) pieces_.push_back({a});
    pieces_.back().push_back(b);
  }

  const MultiPolygon& region_;
  std::vector<Polyline> pieces_;
};

/// Returns the loops around a convex hull, the outermost first.
std::vector<Path> LoopsAround(const Polygon& hull, const SkirtOptions& options) {
  if (hull.size() < 3) return {};
  const Coord spacing_nm = Spacing(options.width_nm, options.height_nm);
  const Box box = Bounds(hull);
  const Point middle{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2};
  std::vector<Path> loops;
  double filament_nm = 0;
  const auto wanted = [&] {
    const auto made = static_cast<int32_t>(loops.size());
    return made < limits::kMaxSkirtLoops &&
           (made < options.loops || filament_nm < static_cast<double>(options.min_length_nm));
  };
  Coord distance_nm = options.distance_nm + options.width_nm / 2;
  for (; wanted(); distance_nm += spacing_nm) {
    const MultiPolygon around = Offset({{hull, {}}}, distance_nm, {.join = Join::kRound});
    if (around.empty()) return {};  // the hull is only a few nm wide
    Polygon ring = around.front().outer;
    if (options.start_angle_rad > kNoStartAngle)
      ring = BeginningAt(std::move(ring), middle, options.start_angle_rad);
    loops.push_back(SkirtLoop(std::move(ring), options));
    filament_nm += FilamentNm(loops.back(), options);
  }
  std::reverse(loops.begin(), loops.end());
  return loops;
}

/// Returns the distance of the centre lines up to which a skirt's outermost bead meets another one.
Coord ReachOf(const std::vector<Path>& skirt) { return skirt.front().widths_nm.front(); }

/// Returns true if the beads of the outermost loops of two skirts meet, or one skirt is inside the
/// other.
bool Meet(const std::vector<Path>& a, const std::vector<Path>& b) {
  return !Intersection(Offset({{a.front().points, {}}}, ReachOf(a)), {{b.front().points, {}}})
              .empty();
}

/// Returns the box of the outermost loop of each skirt; empty for a skirt without loops.
std::vector<Box> BoxesOf(const std::vector<std::vector<Path>>& skirts) {
  std::vector<Box> boxes;
  boxes.reserve(skirts.size());
  for (const std::vector<Path>& loops : skirts)
    boxes.push_back(loops.empty() ? Box() : Bounds(loops.front().points));
  return boxes;
}

/// Joins groups of points if their skirts meet. Returns false if no skirts meet. Cost: O(n log n)
/// for n groups of which few have boxes that meet.
bool JoinMeeting(const std::vector<std::vector<Path>>& skirts, const CancelToken& cancel,
                 std::vector<std::vector<Point>>& groups) {
  const std::vector<Box> boxes = BoxesOf(skirts);
  const BoxIndex index(boxes);
  bool joined = false;
  for (size_t i = groups.size(); i-- > 1 && !cancel.Cancelled();) {
    if (skirts[i].empty()) continue;
    const std::vector<size_t> near = index.Meeting(boxes[i].Grown(ReachOf(skirts[i])));
    const auto first = std::ranges::find_if(
        near, [&](size_t other) { return other >= i || Meet(skirts[i], skirts[other]); });
    if (first == near.end() || *first >= i) continue;
    std::vector<Point>& into = groups[*first];
    into.insert(into.end(), groups[i].begin(), groups[i].end());
    groups[i].clear();
    joined = true;
  }
  std::erase_if(groups, [](const std::vector<Point>& group) { return group.empty(); });
  return joined;
}

}  // namespace

int32_t SkirtLayers(const SkirtOptions& options, int32_t layer_count) {
  if (options.loops <= 0) return 0;
  if (options.draft_shield == DraftShield::kEnabled) return layer_count;
  return std::clamp(options.height_layers, 0, std::max(layer_count, 0));
}

bool SkirtReach::Next(const SlicedLayer& layer) {
  const bool reaches = layers_ < SkirtLayers(options_, layers_ + 1);
  if (!OnlySupports(layer)) ++layers_;
  return reaches;
}

std::vector<std::vector<Path>> SkirtLoops(const MultiPolygon& parts, const MultiPolygon& brims,
                                          const SkirtOptions& options, const CancelToken& cancel) {
  if (options.loops <= 0 || Spacing(options.width_nm, options.height_nm) <= 0) return {};
  std::vector<std::vector<Point>> groups(options.per_object ? 0 : 1);
  const auto add = [&](const MultiPolygon& polygons) {
    for (const PolygonWithHoles& island : polygons) {
      if (options.per_object) groups.emplace_back();
      groups.back().insert(groups.back().end(), island.outer.begin(), island.outer.end());
    }
  };
  add(parts);
  if (options.draft_shield == DraftShield::kDisabled) add(brims);
  std::vector<std::vector<Path>> skirts;
  do {
    skirts.clear();
    for (std::vector<Point>& group : groups) {
      if (cancel.Cancelled()) return {};
      group = ConvexHull(std::move(group));
      skirts.push_back(LoopsAround(group, options));
    }
  } while (JoinMeeting(skirts, cancel, groups));
  std::erase_if(skirts, [](const std::vector<Path>& loops) { return loops.empty(); });
  return skirts;
}

std::vector<Path> WithinBed(std::vector<Path> loops, const MultiPolygon& bed) {
  std::vector<Path> lines;
  for (Path& loop : loops) {
    const MultiPolygon inside = Offset(bed, -loop.widths_nm.front() / 2);
    const Polygon ring = std::move(loop.points);
    if (Difference({{ring, {}}}, inside).empty()) {
      loop.points = ring;
      lines.push_back(std::move(loop));
      continue;
    }
    LineClipper clipper(inside);
    for (size_t i = 0; i < ring.size(); ++i) clipper.Add(ring[i], ring[(i + 1) % ring.size()]);
    loop.closed = false;
    for (Polyline& piece : clipper.TakePieces()) {
      loop.points = std::move(piece);
      lines.push_back(loop);
    }
  }
  return lines;
}

MultiPolygon ShieldKeepOut(const std::vector<std::vector<Path>>& skirts,
                           const SkirtOptions& options) {
  if (options.draft_shield == DraftShield::kDisabled) return {};
  const OffsetOptions round{.join = Join::kRound};
  MultiPolygon bands;
  for (const std::vector<Path>& loops : skirts) {
    MultiPolygon band = Offset({{loops.front().points, {}}}, options.width_nm / 2, round);
    const MultiPolygon inner = Offset({{loops.back().points, {}}}, -options.width_nm / 2, round);
    for (const PolygonWithHoles& hole : inner)
      band.front().holes.emplace_back(hole.outer.rbegin(), hole.outer.rend());
    bands.insert(bands.end(), band.begin(), band.end());
  }
  Canonicalize(bands);
  return bands;
}

}  // namespace slicefarm::planning
