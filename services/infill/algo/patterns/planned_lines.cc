#include "services/infill/algo/patterns/planned_lines.h"

#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> PlannedLines(const MultiPolygon& region,
                                                const PatternContext& context) {
  std::vector<Curve> curves;
  curves.reserve(context.planned.size());
  for (const Polyline& line : context.planned) curves.push_back({.points = line});
  return ClipCurves(region, curves);
}

}  // namespace slicefarm::infill
