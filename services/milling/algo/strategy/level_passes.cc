#include "services/milling/algo/strategy/level_passes.h"

#include <algorithm>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::milling {
namespace {

/// Length below which a ring counts as a point.
constexpr double kLeastRingNm = 10'000;
/// Tolerance for removing points on straight parts of inner rings. Without it, each further inset
/// would multiply the points.
constexpr Coord kRingChordNm = 2'000;

/// Returns true if an area's outer boundary is somewhere on the boundary of `reach`. There the
/// cutter can start beside the stock; elsewhere the boundary is along the part.
bool ReachesOutside(const Polygon& outer, const MultiPolygon& reach) {
  const MultiPolygon inside = Offset(reach, -1'000);
  return std::any_of(outer.begin(), outer.end(), [&](Point p) {
    return std::none_of(inside.begin(), inside.end(), [&](const PolygonWithHoles& island) {
      return Locate(p, island) == Side::kInside;
    });
  });
}

/// Makes the rings of an area by repeated insets. The area is to the left of its outlines. Rings
/// cut from the inside outwards have the remaining stock on the right; rings cut from the outside
/// inwards have it on the left, so they are reversed.
class RingMaker {
 public:
  RingMaker(Coord stepover_nm, bool from_outside, const CancelToken& cancel)
      : stepover_nm_(stepover_nm), from_outside_(from_outside), cancel_(cancel) {}

  void Add(const PolygonWithHoles& area, std::vector<Polygon>& passes, int depth = 0) const {
    if (from_outside_) AddRing({area.outer.rbegin(), area.outer.rend()}, passes);
    if (depth < kMostRings && !cancel_.Cancelled()) {
      const OffsetOptions round{.join = Join::kRound};
      for (const PolygonWithHoles& inner :
           Simplify(Offset({area}, -stepover_nm_, round), kRingChordNm))
        Add(inner, passes, depth + 1);
    }
    for (const Polygon& hole : area.holes) AddRing(hole, passes);
    if (!from_outside_) AddRing(area.outer, passes);
  }

 private:
  static void AddRing(Polygon ring, std::vector<Polygon>& passes) {
    if (Perimeter(ring) >= kLeastRingNm) passes.push_back(std::move(ring));
  }

  Coord stepover_nm_;
  bool from_outside_;
  const CancelToken& cancel_;
};

void Turn(std::vector<Polygon>& passes, CutDirection direction) {
  if (direction == CutDirection::kClimb) return;
  for (Polygon& pass : passes) std::reverse(pass.begin(), pass.end());
}

}  // namespace

std::vector<CutArea> RoughingPasses(const FreeArea& level, const MillingOptions& options,
                                    const CancelToken& cancel) {
  MultiPolygon wide = level.free;
  if (const Coord half = FromMm(options.minimum_width_mm / 2); half > 0)
    wide = Intersection(OffsetTwice(wide, -half, half), level.free);
  std::vector<CutArea> areas;
  for (PolygonWithHoles& area : wide) {
    CutArea cut{.area = std::move(area), .passes = {}};
    const RingMaker rings(FromMm(options.stepover_mm()),
                          ReachesOutside(cut.area.outer, level.reach), cancel);
    rings.Add(cut.area, cut.passes);
    Turn(cut.passes, options.machining.direction);
    areas.push_back(std::move(cut));
  }
  return areas;
}

std::vector<CutArea> FinishingPasses(const FreeArea& level, const MillingOptions& options) {
  std::vector<CutArea> areas;
  for (const PolygonWithHoles& area : level.free) {
    CutArea cut{.area = area, .passes = area.holes};
    cut.passes.push_back(area.outer);
    Turn(cut.passes, options.machining.direction);
    areas.push_back(std::move(cut));
  }
  return areas;
}

}  // namespace slicefarm::milling
