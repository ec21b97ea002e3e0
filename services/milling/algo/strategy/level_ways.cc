#include "services/milling/algo/strategy/level_ways.h"

#include <algorithm>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::milling {
namespace {

/// A ring shorter than this is a point.
constexpr double kLeastRingNm = 10'000;
/// Rings inside lose points on straight stretches, which each inset would multiply.
constexpr Coord kRingChordNm = 2'000;
/// Deeper than this, rings are not followed: no stock is so many stepovers wide.
constexpr int kMostRings = 4'000;

/// Whether an outline runs along the outside of the stock somewhere, not along the part only.
bool ReachesOutside(const Polygon& outer, const MultiPolygon& reach) {
  const MultiPolygon inside = Offset(reach, -1'000);
  return std::any_of(outer.begin(), outer.end(), [&](Point p) {
    return std::none_of(inside.begin(), inside.end(), [&](const PolygonWithHoles& island) {
      return Locate(p, island) == Side::kInside;
    });
  });
}

/// Rings of an area by insets of insets. The free side of an outline is on its left, so what is cut
/// last has its stock on the right; what is cut from the outside inwards has it on the left.
class RingMaker {
 public:
  RingMaker(Coord stepover_nm, bool from_outside)
      : stepover_nm_(stepover_nm), from_outside_(from_outside) {}

  void Add(const PolygonWithHoles& area, std::vector<Polygon>& ways, int depth = 0) const {
    if (from_outside_) AddRing({area.outer.rbegin(), area.outer.rend()}, ways);
    if (depth < kMostRings) {
      const OffsetOptions round{.join = Join::kRound};
      for (const PolygonWithHoles& inner :
           Simplify(Offset({area}, -stepover_nm_, round), kRingChordNm))
        Add(inner, ways, depth + 1);
    }
    for (const Polygon& hole : area.holes) AddRing(hole, ways);
    if (!from_outside_) AddRing(area.outer, ways);
  }

 private:
  static void AddRing(Polygon ring, std::vector<Polygon>& ways) {
    if (Perimeter(ring) >= kLeastRingNm) ways.push_back(std::move(ring));
  }

  Coord stepover_nm_;
  bool from_outside_;
};

void Turn(std::vector<Polygon>& ways, CutDirection direction) {
  if (direction == CutDirection::kClimb) return;
  for (Polygon& way : ways) std::reverse(way.begin(), way.end());
}

}  // namespace

std::vector<CutArea> RoughingWays(const FreeArea& level, const MillingOptions& options) {
  MultiPolygon wide = level.free;
  if (const Coord half = FromMm(options.minimum_width_mm / 2); half > 0)
    wide = Intersection(OffsetTwice(wide, -half, half), level.free);
  std::vector<CutArea> areas;
  for (PolygonWithHoles& area : wide) {
    CutArea cut{.area = std::move(area), .ways = {}};
    const RingMaker rings(FromMm(options.stepover_mm()),
                          ReachesOutside(cut.area.outer, level.reach));
    rings.Add(cut.area, cut.ways);
    Turn(cut.ways, options.machining.direction);
    areas.push_back(std::move(cut));
  }
  return areas;
}

std::vector<CutArea> FinishingWays(const FreeArea& level, const MillingOptions& options) {
  std::vector<CutArea> areas;
  for (const PolygonWithHoles& area : level.free) {
    CutArea cut{.area = area, .ways = area.holes};
    cut.ways.push_back(area.outer);
    Turn(cut.ways, options.machining.direction);
    areas.push_back(std::move(cut));
  }
  return areas;
}

}  // namespace slicefarm::milling
