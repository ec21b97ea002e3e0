#include "services/infill/algo/patterns/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "common/geometry/measure.h"
#include "services/infill/algo/axis/axis_levels.h"
#include "services/infill/algo/axis/main_axis.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Where the lines of one layer lie, by their distance from the axis.
struct AxisPhase {
  double first_nm = 0;
  bool on_axis = false;  ///< the axis itself is a line
};

/// A pair closer to the axis than `merged` is one line, for twice that time.
AxisPhase PhaseAt(Coord z_nm, double pitch_nm, double merged_nm) {
  const double turns = -static_cast<double>(z_nm) / pitch_nm;
  const double phase = (turns - std::floor(turns)) * pitch_nm;
  if (phase < merged_nm) return {phase + pitch_nm, true};
  return {phase, phase >= pitch_nm - merged_nm};
}

double DistanceToLines(Point p, std::span<const Polyline> lines) {
  double least = std::numeric_limits<double>::max();
  for (const Polyline& line : lines)
    for (size_t i = 1; i < line.size(); ++i)
      least = std::min(least, DistanceToSegment(p, line[i - 1], line[i]));
  return least;
}

/// The farthest place of an island from its axis is one of its corners, or lies between two
/// branches, no farther than the width of the box.
double FarthestFrom(std::span<const Polyline> axis, const PolygonWithHoles& island) {
  double most = 0;
  for (const Point p : island.outer) most = std::max(most, DistanceToLines(p, axis));
  return most;
}

absl::StatusOr<std::vector<Piece>> AroundAxis(const PolygonWithHoles& island,
                                              const PatternPlace& place) {
  const std::vector<Polyline> axis = MainAxis(island, {.least_nm = place.pitch_nm / 2});
  const AxisPhase phase =
      PhaseAt(place.z_nm, place.pitch_nm, std::min(place.pitch_nm, 1.0 * place.spacing_nm) / 2);
  const double most = FarthestFrom(axis, island);
  if (absl::Status ok = CheckLineCount(most / place.pitch_nm * static_cast<double>(axis.size()));
      !ok.ok())
    return ok;
  std::vector<Curve> curves = AxisLevels(axis, phase.first_nm, place.pitch_nm, most);
  if (phase.on_axis)
    for (const Polyline& line : axis) curves.push_back({.points = line});
  return ClipCurves({island}, curves);
}

}  // namespace

absl::StatusOr<std::vector<Piece>> MedialAxis(const MultiPolygon& region,
                                              const PatternPlace& place) {
  std::vector<Piece> all;
  int32_t rings = 0;
  for (const PolygonWithHoles& island : region) {
    auto pieces = AroundAxis(island, place);
    if (!pieces.ok()) return pieces.status();
    for (Piece& piece : *pieces) {
      for (EdgePlace* end : {&piece.from, &piece.to})
        if (end->ring >= 0) end->ring += rings;
      all.push_back(std::move(piece));
    }
    rings += 1 + static_cast<int32_t>(island.holes.size());
  }
  return all;
}

}  // namespace slicefarm::infill
