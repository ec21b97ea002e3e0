#include "services/infill/algo/axis/axis_levels.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::infill {
namespace {

/// Increase of the first line's radius on arcs, as a share of the radius. An arc has 42 chords per
/// turn, which are nearer to the axis than the arc itself.
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
