#include "services/infill/algo/patterns/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "common/geometry/measure.h"
#include "services/infill/algo/axis/axis_levels.h"
#include "services/infill/algo/axis/axis_spokes.h"
#include "services/infill/algo/axis/main_axis.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/line_limit.h"
#include "services/infill/algo/lines/smoothed.h"

namespace slicefarm::infill {
namespace {

/// Smallest distance between smoothed lines, as a share of their pitch.
constexpr double kLeastPitchShare = 0.5;

/// Positions of the lines of one layer, as distances from the axis.
struct AxisPhase {
  double first_nm = 0;
  bool on_axis = false;  ///< the axis itself is a line
};

/// Returns the phase of a layer. Two lines on both sides of the axis and nearer than a spacing to
/// each other become one line on the axis. After they have met, this line continues for the same
/// height. The phase uses the nominal pitch, so that lines of layers with slightly different
/// pitches are above each other.
AxisPhase PhaseAt(const PatternContext& context, double pitch_nm) {
  const double turns = -static_cast<double>(context.z_nm) / context.pitch_nm;
  const double phase = (turns - std::floor(turns)) * pitch_nm;
  const double merged = std::min(pitch_nm, static_cast<double>(context.spacing_nm)) / 2;
  if (phase < merged) return {phase + pitch_nm, true};
  return {phase, phase >= pitch_nm - merged};
}

double PiecesLength(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces)
    length += piece.closed ? Perimeter(piece.points) : Length(piece.points);
  return length;
}

double DistanceToLines(Point p, std::span<const Polyline> lines) {
  double least = std::numeric_limits<double>::max();
  for (const Polyline& line : lines)
    for (size_t i = 1; i < line.size(); ++i)
      least = std::min(least, DistanceToSegment(p, line[i - 1], line[i]));
  return least;
}

Curve CurveAlong(const Polyline& line) {
  Curve curve{line, line.size() > 3 && line.front() == line.back()};
  if (curve.closed) curve.points.pop_back();
  return curve;
}

/// Returns the main axis of an island and the spokes that join it to all rings of the island.
std::vector<Polyline> JoinedAxis(const PolygonWithHoles& island, double least_nm) {
  std::vector<Polyline> axis = MainAxis(island, {.least_nm = least_nm});
  std::vector<Polyline> spokes = AxisSpokes(island, axis);
  std::ranges::move(spokes, std::back_inserter(axis));
  return axis;
}

/// Lines of an island before they are cut.
class AxisLines {
 public:
  AxisLines(const PolygonWithHoles& island, const PatternContext& context)
      : context_(context), axis_(JoinedAxis(island, context.pitch_nm / 2)) {
    ForEachRing({island}, [this](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i)
        LookAtEdge(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    });
  }

  std::vector<Curve> Curves(double pitch_nm, double smoothing_nm) const {
    const AxisPhase phase = PhaseAt(context_, pitch_nm);
    std::vector<Curve> curves = AxisLevels(axis_, phase.first_nm, pitch_nm, most_nm_);
    if (phase.on_axis) std::ranges::transform(axis_, std::back_inserter(curves), CurveAlong);
    for (Curve& curve : curves) curve = Smoothed(curve, smoothing_nm);
    return curves;
  }

 private:
  /// Samples an edge at points a pitch apart. Between two samples, the distance from the axis is at
  /// most half a pitch larger.
  void LookAtEdge(Point a, Point b) {
    const auto steps = static_cast<int>(std::ceil(Distance(a, b) / context_.pitch_nm));
    for (int i = 0; i < steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const Point p{a.x + std::llround(share * static_cast<double>(b.x - a.x)),
                    a.y + std::llround(share * static_cast<double>(b.y - a.y))};
      most_nm_ = std::max(most_nm_, DistanceToLines(p, axis_) + context_.pitch_nm / 2);
    }
  }

  const PatternContext& context_;
  const std::vector<Polyline> axis_;
  double most_nm_ = 0;  ///< greatest distance of the island's edge from the axis
};

/// Returns the parts of the lines inside an island. Smoothed lines are shorter, so that their pitch
/// is reduced to keep the length.
std::vector<Piece> PiecesInside(const PolygonWithHoles& island, const AxisLines& lines,
                                const PatternContext& context) {
  const auto smoothing = static_cast<double>(context.smoothing_nm);
  std::vector<Piece> pieces = ClipCurves({island}, lines.Curves(context.pitch_nm, smoothing));
  if (smoothing <= 0) return pieces;
  const double asked = PiecesLength(ClipCurves({island}, lines.Curves(context.pitch_nm, 0)));
  const double got = PiecesLength(pieces);
  if (asked <= 0 || got <= 0) return pieces;
  const double share = std::clamp(got / asked, kLeastPitchShare, 1.0);
  return ClipCurves({island}, lines.Curves(context.pitch_nm * share, smoothing));
}

absl::StatusOr<std::vector<Piece>> AroundAxis(const PolygonWithHoles& island,
                                              const PatternContext& context) {
  // Lines are counted in parts as long as the pitch, like the cells of a space-filling curve.
  const double spans = Area(island) / (context.pitch_nm * context.pitch_nm);
  if (absl::Status ok = CheckLineCount(spans); !ok.ok()) return ok;
  return PiecesInside(island, AxisLines(island, context), context);
}

}  // namespace

absl::StatusOr<std::vector<Piece>> MedialAxis(const MultiPolygon& region,
                                              const PatternContext& context) {
  std::vector<Piece> all;
  int32_t rings = 0;
  for (const PolygonWithHoles& island : region) {
    auto pieces = AroundAxis(island, context);
    if (!pieces.ok()) return pieces.status();
    for (Piece& piece : *pieces) {
      for (EdgePosition* end : {&piece.from, &piece.to})
        if (end->ring >= 0) end->ring += rings;
      all.push_back(std::move(piece));
    }
    rings += 1 + static_cast<int32_t>(island.holes.size());
  }
  return all;
}

}  // namespace slicefarm::infill
