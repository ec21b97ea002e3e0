#include "processes/fdm/job/bed_warnings.h"

#include <map>
#include <set>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::coordinator {
namespace {

/// Distance from the boundary of the bed, in nm, below which a region counts as cut by the
/// boundary.
constexpr Coord kAtEdgeNm = 20'000;
constexpr size_t kNamed = 5;

using Objects = std::set<int32_t>;

/// Returns the objects that are nearest to the convex polygon `place`.
Objects NearestTo(const Polygon& place, std::span<const PlacedCopy> copies) {
  std::map<double, Objects> by_distance;
  for (const PlacedCopy& copy : copies)
    by_distance[ConvexDistance(place, copy.footprint)].insert(copy.object);
  return by_distance.empty() ? Objects() : by_distance.begin()->second;
}

/// Returns the objects that are nearest to the points where a region reaches the boundary of the
/// bed.
Objects CutBeside(const MultiPolygon& region, const MultiPolygon& bed,
                  std::span<const PlacedCopy> copies) {
  Objects objects;
  for (const PolygonWithHoles& beyond : Difference(Offset(region, kAtEdgeNm), bed))
    objects.merge(NearestTo(ConvexHull(beyond.outer), copies));
  return objects;
}

/// Returns the objects nearest to the ends of open loops.
Objects OpenBeside(std::span<const Path> loops, std::span<const PlacedCopy> copies) {
  Objects objects;
  for (const Path& loop : loops) {
    if (loop.closed) continue;
    objects.merge(NearestTo({loop.points.front()}, copies));
    objects.merge(NearestTo({loop.points.back()}, copies));
  }
  return objects;
}

std::string Warning(const std::string& what, const Objects& objects,
                    std::span<const std::string> names) {
  std::vector<std::string> named;
  for (const int32_t object : objects)
    if (named.size() < kNamed) named.push_back(names[static_cast<size_t>(object)]);
  if (objects.size() > kNamed) {
    named.back() += absl::StrCat(" and ", objects.size() - kNamed, " more");
  }
  return absl::StrCat(absl::StrJoin(named, ", "), ": the ", what,
                      " reaches the edge of the bed and is cut there");
}

}  // namespace

std::vector<std::string> BedWarnings(const JobPlan& plan, const MultiPolygon& bed,
                                     std::span<const PlacedCopy> copies,
                                     std::span<const std::string> names) {
  if (bed.empty()) return {};
  std::map<std::string, Objects> cut;
  for (const AddedStack& added : plan.stacks) {
    if (added.stack.object != kPlateObject) continue;
    for (const ObjectSection& section : added.sections)
      for (const Region& region : section.regions)
        cut[added.stack.kind == StackKind::kBrim ? "brim" : "raft"].merge(
            CutBeside(region.outlines, bed, copies));
  }
  if (!plan.skirt.loops.empty()) cut["skirt"] = OpenBeside(plan.skirt.loops, copies);
  std::vector<std::string> warnings;
  for (const auto& [what, objects] : cut)
    if (!objects.empty()) warnings.push_back(Warning(what, objects, names));
  return warnings;
}

}  // namespace slicefarm::coordinator
