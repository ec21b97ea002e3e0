#include "services/planning/algo/adhesion/brim.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::planning {
namespace {

constexpr OffsetOptions kRound{.join = Join::kRound};

Coord Separation(const BrimOptions& options) { return std::max<Coord>(options.separation_nm, 0); }

bool HasBrim(const BrimOptions& options) {
  return options.type != BrimType::kNone && options.width_nm > 0;
}

/// Returns the region with its holes filled.
MultiPolygon Filled(const MultiPolygon& outlines) {
  std::vector<Polygon> outers;
  outers.reserve(outlines.size());
  for (const PolygonWithHoles& island : outlines) outers.push_back(island.outer);
  return Union(outers, FillRule::kNonZero);
}

/// Removes the pieces that are thinner than half a line. The result never exceeds the region.
MultiPolygon WithoutSlivers(const MultiPolygon& region, Coord line_width_nm) {
  const Coord radius_nm = line_width_nm / 4;
  if (radius_nm <= 0 || region.empty()) return region;
  return Intersection(OffsetTwice(region, -radius_nm, radius_nm), region);
}

/// Returns true if the interior angle at b is below the limit; false for a reflex corner.
bool IsSharp(Point a, Point b, Point c, double max_angle_rad) {
  const Point back = a - b, on = c - b;
  if (Cross(on, back) <= 0) return false;
  return Atan2(Cross(on, back), Dot(on, back)) < max_angle_rad;
}

Polygon Disc(Point center, Coord radius_nm) {
  const double step = 2 * Acos(1 - std::min(1.0, 2'500.0 / static_cast<double>(radius_nm)));
  const int points = std::max(8, static_cast<int>(std::ceil(2 * std::numbers::pi / step)));
  Polygon disc;
  disc.reserve(points);
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    disc.push_back({center.x + std::llround(static_cast<double>(radius_nm) * Cos(t)),
                    center.y + std::llround(static_cast<double>(radius_nm) * Sin(t))});
  }
  return disc;
}

/// Unites discs by halves. One union of all discs would compute too many crossings, as the discs
/// cover each other.
MultiPolygon United(std::span<const Polygon> discs) {
  constexpr size_t kFew = 8;
  if (discs.size() <= kFew)
    return Union(std::vector<Polygon>(discs.begin(), discs.end()), FillRule::kNonZero);
  const size_t half = discs.size() / 2;
  return Union(United(discs.first(half)), United(discs.subspan(half)));
}

/// Returns discs around the sharp corners of the rings of islands.
MultiPolygon Ears(const MultiPolygon& outlines, const BrimOptions& options) {
  std::vector<Polygon> discs;
  ForEachRing(outlines, [&](const Polygon& outline) {
    const Polygon ring = SimplifyRing(outline, options.ear_detection_nm);
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point before = ring[(i + ring.size() - 1) % ring.size()];
      if (IsSharp(before, ring[i], ring[(i + 1) % ring.size()], options.ear_max_angle_rad))
        discs.push_back(Disc(ring[i], options.width_nm));
    }
  });
  return United(discs);
}

/// Returns the area of the brim that follows from the object's own rings, before other objects are
/// considered. The area may include the part itself.
MultiPolygon Zone(const BrimObject& object) {
  const BrimOptions& options = object.options;
  const MultiPolygon filled = Filled(object.outlines);
  if (options.type == BrimType::kEars) {
    const MultiPolygon& corners = options.ears_outside_only ? filled : object.outlines;
    return Difference(Ears(corners, options), corners);
  }
  const MultiPolygon wide = Offset(object.outlines, Separation(options) + options.width_nm, kRound);
  if (options.type == BrimType::kOuterAndInner) return wide;
  return options.type == BrimType::kOuterOnly ? Difference(wide, filled)
                                              : Intersection(wide, filled);
}

/// Intermediate data of one object.
struct Work {
  MultiPolygon keep_out;  ///< area that has no brim of any object
  MultiPolygon brim;      ///< brim of the object, as if no other object had one
  Box keep_out_box;
  Box brim_box;
};

/// Keeps the pieces that reach the keep-out region of their own object.
MultiPolygon Attached(MultiPolygon pieces, const BrimObject& object) {
  if (pieces.empty()) return pieces;
  const MultiPolygon reach = Offset(
      object.outlines, Separation(object.options) + object.options.line_width_nm / 2, kRound);
  std::erase_if(
      pieces, [&](const PolygonWithHoles& piece) { return Intersection({piece}, reach).empty(); });
  return pieces;
}

MultiPolygon Candidate(std::span<const BrimObject> objects, const std::vector<Work>& works,
                       size_t i, const MultiPolygon& bed) {
  if (!HasBrim(objects[i].options) || objects[i].outlines.empty()) return {};
  MultiPolygon brim = Zone(objects[i]);
  if (!bed.empty()) brim = Intersection(brim, bed);
  const Box box = Bounds(brim);
  for (const Work& other : works) {
    if (box.Intersects(other.keep_out_box)) brim = Difference(brim, other.keep_out);
  }
  brim = WithoutSlivers(brim, objects[i].options.line_width_nm);
  return Attached(std::move(brim), objects[i]);
}

/// Returns the pieces of `rest` that are not in `kept`, because they are too thin for a line.
/// Pieces that rounding causes are left out.
MultiPolygon Slivers(const MultiPolygon& rest, const MultiPolygon& kept) {
  MultiPolygon slivers = Difference(rest, kept);
  std::erase_if(slivers,
                [](const PolygonWithHoles& piece) { return Offset({piece}, -kGlueNm).empty(); });
  return slivers;
}

/// Adds a sliver, cut off from another object's brim, to the brim of the first object in `givers`
/// that it touches. The enlarged brim stays within `free` and its own area.
void GiveBack(const PolygonWithHoles& sliver, std::vector<Work>& works,
              const std::vector<size_t>& givers, const MultiPolygon& free) {
  const MultiPolygon grown = Offset({sliver}, 2 * kGlueNm);
  for (const size_t to : givers) {
    MultiPolygon& brim = works[to].brim;
    if (Intersection(grown, brim).empty()) continue;
    const MultiPolygon glued = OffsetTwice(Union(brim, {sliver}), kGlueNm, -kGlueNm);
    MultiPolygon allowed = Union(free, brim);
    for (const size_t other : givers) {
      if (other != to) allowed = Difference(allowed, works[other].brim);
    }
    brim = Intersection(glued, allowed);
    works[to].brim_box = Bounds(brim);
    return;
  }
}

/// Removes the area of earlier objects' brims from the brim of object `i`.
void GiveWay(std::vector<Work>& works, size_t i, Coord line_width_nm) {
  std::vector<size_t> before;
  for (size_t j = 0; j < i; ++j) {
    if (works[i].brim_box.Intersects(works[j].brim_box)) before.push_back(j);
  }
  const MultiPolygon whole = works[i].brim;
  MultiPolygon rest = whole;
  for (const size_t j : before) rest = Difference(rest, works[j].brim);
  if (before.empty() || rest == whole) return;
  MultiPolygon& kept = works[i].brim;
  kept = WithoutSlivers(rest, line_width_nm);
  works[i].brim_box = Bounds(kept);
  const MultiPolygon slivers = Slivers(rest, kept);
  if (slivers.empty()) return;
  const MultiPolygon free = Difference(whole, kept);
  for (const PolygonWithHoles& sliver : slivers) GiveBack(sliver, works, before, free);
}

/// Removes rounding errors: tiny pieces and overlaps with parts.
MultiPolygon Finished(MultiPolygon brim, const std::vector<Work>& works, Coord line_width_nm) {
  const Box box = Bounds(brim);
  for (const Work& work : works) {
    if (box.Intersects(work.keep_out_box)) brim = Difference(brim, work.keep_out);
  }
  std::erase_if(brim, [&](const PolygonWithHoles& piece) {
    return Offset({piece}, kGlueNm - line_width_nm / 4).empty();
  });
  return brim;
}

}  // namespace

absl::StatusOr<std::vector<MultiPolygon>> BrimRegions(std::span<const BrimObject> objects,
                                                      const MultiPolygon& bed,
                                                      const CancelToken& cancel) {
  std::vector<Work> works(objects.size());
  for (size_t i = 0; i < objects.size(); ++i) {
    works[i].keep_out = Offset(objects[i].outlines, Separation(objects[i].options), kRound);
    works[i].keep_out_box = Bounds(works[i].keep_out);
  }
  for (size_t i = 0; i < objects.size(); ++i) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    works[i].brim = Candidate(objects, works, i, bed);
    works[i].brim_box = Bounds(works[i].brim);
  }
  for (size_t i = 0; i < objects.size(); ++i) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    GiveWay(works, i, objects[i].options.line_width_nm);
  }
  std::vector<MultiPolygon> regions;
  for (size_t i = 0; i < objects.size(); ++i)
    regions.push_back(Finished(works[i].brim, works, objects[i].options.line_width_nm));
  return regions;
}

}  // namespace slicefarm::planning
