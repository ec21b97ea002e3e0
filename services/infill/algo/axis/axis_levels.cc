#include "services/infill/algo/axis/axis_levels.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::infill {
namespace {

/// Extra distance of arcs of the first line, as a share of the radius: an arc has 42 chords per
/// turn, and the chords are closer to the axis than the arc.
constexpr double kArcShare = 1.0 / 350;

}  // namespace

std::vector<Curve> AxisLevels(std::span<const Polyline> axis, double first_nm, double pitch_nm,
                              double most_nm) {
  std::vector<Curve> curves;
  if (first_nm > most_nm) return curves;
  MultiPolygon around =
      OffsetLines(axis, std::max<Coord>(1, std::llround(first_nm)), Cap::kRound,
                  {.join = Join::kRound,
                   .arc_tolerance_nm = std::max<Coord>(1, std::llround(first_nm * kArcShare))});
  Coord at = std::llround(first_nm);
  for (int k = 1;; ++k) {
    ForEachRing(around, [&curves](const Polygon& ring) { curves.push_back({ring, true}); });
    const Coord next = std::llround(first_nm + k * pitch_nm);
    if (static_cast<double>(next) > most_nm || around.empty()) return curves;
    around = FastOffset(around, std::max<Coord>(1, next - at));
    at = next;
  }
}

}  // namespace slicefarm::infill
