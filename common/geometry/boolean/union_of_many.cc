#include "common/geometry/boolean/union_of_many.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/clipper_convert.h"
#include "common/geometry/measure.h"

namespace slicefarm {
namespace {

using ClipperLib::Paths;

/// Number of rings that a sweep of the lowest level unites, and number of groups that a sweep of
/// each higher level unites.
constexpr size_t kRingsAtOnce = 32, kGroupsAtOnce = 4;

/// Returns the low 32 bits of `value` with a zero before each bit.
uint64_t Spread(uint64_t value) {
  value &= 0xffff'ffff;
  value = (value | value << 16) & 0x0000'ffff'0000'ffff;
  value = (value | value << 8) & 0x00ff'00ff'00ff'00ff;
  value = (value | value << 4) & 0x0f0f'0f0f'0f0f'0f0f;
  value = (value | value << 2) & 0x3333'3333'3333'3333;
  return (value | value << 1) & 0x5555'5555'5555'5555;
}

/// Returns the position of a point on a Z-order curve from `origin`. Points that are close to each
/// other are close on the curve.
uint64_t PlaceOnCurve(Point p, Point origin) {
  return Spread(static_cast<uint64_t>(p.x - origin.x)) |
         Spread(static_cast<uint64_t>(p.y - origin.y)) << 1;
}

/// Sorts rings so that neighbours are next to each other. The order depends only on their
/// positions.
void SortByPlace(std::vector<Polygon>& rings) {
  std::vector<std::pair<uint64_t, Polygon>> placed;
  Box all;
  for (const Polygon& ring : rings) all.Add(Bounds(ring));
  for (Polygon& ring : rings) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    const Box box = Bounds(ring);
    const Point middle = {(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2};
    placed.emplace_back(PlaceOnCurve(middle, all.min), std::move(ring));
  }
  std::ranges::sort(placed);
  rings.clear();
  for (auto& [place, ring] : placed) rings.push_back(std::move(ring));
}

/// Unites groups [from, to). It does not use a Clipper tree, because Clipper's time for a tree
/// grows with the square of the number of rings.
Paths United(const std::vector<Paths>& groups, size_t from, size_t to) {
  if (to == from + 1) return groups[from];
  ClipperLib::Clipper clipper;
  for (size_t i = from; i < to; ++i) clipper.AddPaths(groups[i], ClipperLib::ptSubject, true);
  Paths united;
  clipper.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return united;
}

/// Returns the groups of the next level: each `count` consecutive groups are united to one.
std::vector<Paths> NextLevel(const std::vector<Paths>& groups, size_t count,
                             const CancelToken& cancel) {
  std::vector<Paths> next;
  for (size_t from = 0; from < groups.size() && !cancel.Cancelled(); from += count)
    next.push_back(United(groups, from, std::min(from + count, groups.size())));
  return next;
}

}  // namespace

MultiPolygon UnionOfMany(std::vector<Polygon> rings, const CancelToken& cancel) {
  if (rings.size() <= kRingsAtOnce) return Union(rings, FillRule::kNonZero);
  SortByPlace(rings);
  std::vector<Paths> groups;
  groups.reserve(rings.size());
  for (const Polygon& ring : rings) groups.push_back({internal::ToPath(ring)});
  groups = NextLevel(groups, kRingsAtOnce, cancel);
  while (groups.size() > kGroupsAtOnce && !cancel.Cancelled())
    groups = NextLevel(groups, kGroupsAtOnce, cancel);
  if (cancel.Cancelled()) return {};
  std::vector<Polygon> united;
  for (const Paths& group : groups)
    for (const ClipperLib::Path& path : group) united.push_back(internal::FromPath(path));
  return Union(united, FillRule::kNonZero);
}

}  // namespace slicefarm
