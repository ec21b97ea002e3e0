#include "services/infill/algo/solid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/scan_lines.h"
#include "services/infill/algo/lines/strip_ramps.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/linking/serpentine.h"
#include "services/infill/algo/linking/solid_beads.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

constexpr double kLeastStretch = 0.85;
constexpr double kMostStretch = 1.2;
/// Largest distance along the region's boundary between two ends that are joined, in spacings.
constexpr double kMaxLinkSpacings = 8.0;
/// Smallest length of a path, in widths. A shorter path covers less than the gaps beside the round
/// ends of its neighbours.
constexpr double kMinLengthWidths = 1.0;
/// Distance of lines' ends from the boundary beside walls, as a share of the distance elsewhere:
/// for lines joined by links, and for separate lines.
constexpr double kLinkedShare = 0.36, kFreeShare = 0.25;
/// Width of a link's strip beside walls, in spacings. It fills the area that lines with ends so
/// near to the boundary leave empty.
constexpr double kLinkShare = 0.15;
/// Largest total length of links between curves, as a share of the curves' length.
constexpr double kMostLinkShare = 0.01;
constexpr double kDepthPrecision = 0.001;  // in spacings

/// Returns the distance of lines' ends from the region's boundary.
Coord EndDistance(Coord spacing, Coord overlap) {
  return std::max<Coord>(0, spacing / 2 - overlap);
}

/// Returns true if straight lines are fitted to the space between walls. Bridges are not fitted: a
/// strand in the air keeps the thickness with which it leaves the nozzle. Without walls, the lines'
/// ends form the boundary.
bool FitsWalls(const SolidFill& fill) { return fill.beside_walls && !IsBridge(fill.feature); }

/// Returns the distance of straight lines' ends from the region's boundary.
Coord LineEndDistance(Coord spacing, const SolidFill& fill) {
  if (fill.anchored) return 0;
  const Coord full = EndDistance(spacing, fill.overlap_nm);
  if (!FitsWalls(fill)) return full;
  const double share = fill.pattern == FillPattern::kMonotonicLines ? kFreeShare : kLinkedShare;
  return std::llround(share * static_cast<double>(full));
}

/// Returns lines across an area with the outermost lines `margin` inside of it, if the required
/// change of the pitch is permitted. Otherwise returns the nearest number of lines, centred in the
/// area.
LineFamily FittingLines(const MultiPolygon& area, double angle_rad, double spacing, double margin) {
  const FrameBox extent = BoxIn(LineAxes(angle_rad), area);
  const double height = extent.max_v - extent.min_v - 2 * margin + spacing;
  const double count = std::max(1.0, std::round(height / spacing));
  const double pitch = std::clamp(height / count, kLeastStretch * spacing, kMostStretch * spacing);
  return {angle_rad, (extent.min_v + extent.max_v) / 2 - (count - 1) / 2 * pitch, pitch};
}

/// Returns one line through the middle of an area that no line of `family` meets.
LineFamily MiddleLine(const MultiPolygon& area, LineFamily family) {
  const FrameBox extent = BoxIn(LineAxes(family.angle_rad), area);
  family.phase_nm = (extent.min_v + extent.max_v) / 2;
  return family;
}

/// Returns half of the greatest width of a region, to `precision`.
double DepthOf(const MultiPolygon& region, double at_most, double precision) {
  double low = 0, high = at_most;
  while (high - low > precision) {
    const double middle = (low + high) / 2;
    (FastOffset(region, -std::llround(middle)).empty() ? high : low) = middle;
  }
  return high;
}

/// Returns the distance between loops for which they leave no space in the middle.
double FittingLoops(const MultiPolygon& region, double spacing) {
  const Box box = Bounds(region);
  const auto size = static_cast<double>(std::min(box.max.x - box.min.x, box.max.y - box.min.y));
  const double depth = DepthOf(region, size / 2 + 1, kDepthPrecision * spacing);
  const double count = std::max(1.0, std::round(depth / spacing));
  return std::clamp(depth / count, kLeastStretch * spacing, kMostStretch * spacing);
}

absl::StatusOr<FillGroup> FillByLines(const PolygonWithHoles& region, const SolidFill& fill) {
  const bool linked = fill.pattern != FillPattern::kMonotonicLines;
  const Coord nominal = Spacing(fill.width_nm, fill.height_nm);
  const Coord inset = LineEndDistance(nominal, fill);
  MultiPolygon area = FastOffset({region}, -inset);
  if (area.empty()) return FillGroup{};
  const auto wanted = static_cast<double>(nominal);
  const LineFamily family =
      FittingLines(area, fill.angle_rad, wanted, wanted / 2 - static_cast<double>(inset));
  const Coord spacing = std::llround(family.pitch_nm);
  const Coord ends = LineEndDistance(spacing, fill);
  if (ends != inset) area = FastOffset({region}, -ends);
  auto lines = CutLines(area, family);
  if (lines.ok() && lines->PieceCount() == 0) lines = CutLines(area, MiddleLine(area, family));
  if (!lines.ok()) return lines.status();

  FillGroup group;
  group.keep_order = !linked || fill.pattern == FillPattern::kMonotonic;
  SerpentineOptions options{.monotonic = group.keep_order,
                            .max_link_nm = linked ? kMaxLinkSpacings * family.pitch_nm : 0,
                            .min_length_nm = kMinLengthWidths * static_cast<double>(WidthForSpacing(
                                                                    spacing, fill.height_nm))};
  std::vector<SerpentinePath> paths = Serpentine(*lines, options);
  // In a separate area that has only short lines, these lines are kept: they are not the ends of
  // neighbour lines.
  if (paths.empty() && Area(region) >= wanted * wanted) {
    options.min_length_nm = 0;
    paths = Serpentine(*lines, options);
  }
  const SolidBeads beads(region, *lines, paths,
                         {.fitted = FitsWalls(fill),
                          .reach_nm = static_cast<double>(ends),
                          .link_share = FitsWalls(fill) ? kLinkShare : 1});
  for (const SerpentinePath& line : paths) {
    Path& path = group.paths.emplace_back(PathOfStrip(beads.BeadOf(line), fill.height_nm));
    path.feature = fill.feature;
    path.reversible = !group.keep_order;
  }
  return group;
}

/// Returns the middle of a region's extent along the pattern's axes.
Point MiddleOf(const MultiPolygon& region, double angle_rad) {
  const LineAxes axes(angle_rad);
  const FrameBox box = BoxIn(axes, region);
  return axes.At((box.min_u + box.max_u) / 2, (box.min_v + box.max_v) / 2);
}

/// Returns the curves of the pattern inside the area, around the middle that the fill asks for.
absl::StatusOr<std::vector<Piece>> CurvesOf(const MultiPolygon& area, const SolidFill& fill,
                                            double pitch) {
  const Coord spacing = std::llround(pitch);
  const PatternContext context{0, fill.layer, pitch, fill.angle_rad, spacing};
  if (!IsSpiral(fill.pattern)) return PatternOf(fill.pattern)(area, context);
  const Point middle = fill.center.value_or(MiddleOf(area, fill.angle_rad));
  auto pieces =
      PatternOf(fill.pattern)(middle == Point{} ? area : Moved(area, Point{} - middle), context);
  if (!pieces.ok()) return pieces;
  if (fill.order != FillOrder::kNearest) {
    // Pieces follow one another along the spiral, but the one at its start may come last.
    const auto start =
        std::ranges::find_if(*pieces, [](const Piece& p) { return p.from.ring < 0; });
    if (start != pieces->end()) std::rotate(pieces->begin(), start, pieces->end());
  }
  for (Piece& piece : *pieces)
    for (Point& p : piece.points) p = p + middle;
  return pieces;
}

/// Puts paths in the order of the fill. Loops come from the edge to the middle, parts of a spiral
/// from the middle to the edge.
void PutInOrder(const SolidFill& fill, FillGroup& group) {
  group.keep_order = true;
  const bool comes_outward = IsSpiral(fill.pattern);
  const bool turn = comes_outward != (fill.order == FillOrder::kOutward);
  if (turn) std::ranges::reverse(group.paths);
  for (Path& path : group.paths) {
    if (path.closed) continue;
    path.reversible = false;
    if (turn) std::ranges::reverse(path.points);
  }
}

absl::StatusOr<FillGroup> FillByCurves(const PolygonWithHoles& region, const SolidFill& fill) {
  auto pitch = static_cast<double>(Spacing(fill.width_nm, fill.height_nm));
  // Lines along the region's boundary are half a spacing from it in any case, side by side with the
  // wall. None of their ends has to reach into the wall.
  const bool along_edge = InfoOf(fill.pattern).solid == SolidFillStyle::kAlongEdge;
  const Coord inset = along_edge ? 0 : EndDistance(std::llround(pitch), fill.overlap_nm);
  const MultiPolygon area = FastOffset({region}, -inset);
  if (area.empty()) return FillGroup{};
  if (fill.pattern == FillPattern::kConcentric) pitch = FittingLoops(area, pitch);
  const Coord spacing = std::llround(pitch);
  const auto pieces = CurvesOf(area, fill, pitch);
  if (!pieces.ok()) return pieces.status();
  const Coord width = WidthForSpacing(spacing, fill.height_nm);
  const bool ordered = fill.order != FillOrder::kNearest && HasMiddle(fill.pattern);
  FillGroup group;
  group.paths = LinkedPaths(area, *pieces,
                            {.width_nm = width,
                             .max_link_nm = ordered ? 0 : kMaxLinkSpacings * pitch,
                             .budget_nm = kMostLinkShare * Area(region) / pitch,
                             .lifts_ends = false,
                             .min_length_nm = kMinLengthWidths * static_cast<double>(width)});
  for (Path& path : group.paths) path.feature = fill.feature;
  if (ordered) PutInOrder(fill, group);
  return group;
}

}  // namespace

bool HasMiddle(FillPattern pattern) {
  return pattern == FillPattern::kConcentric || IsSpiral(pattern);
}

bool IsAligned(FillPattern pattern) {
  return pattern == FillPattern::kAlignedRectilinear || pattern == FillPattern::kZigzag;
}

absl::StatusOr<FillGroup> FillSolid(const PolygonWithHoles& region, const SolidFill& fill) {
  const bool lines = InfoOf(fill.pattern).solid == SolidFillStyle::kLines;
  return lines ? FillByLines(region, fill) : FillByCurves(region, fill);
}

}  // namespace slicefarm::infill
