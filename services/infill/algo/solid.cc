#include "services/infill/algo/solid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry/measure.h"
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
/// Ends that lie farther apart along the edge than this many spacings are not joined.
constexpr double kMaxLinkSpacings = 8.0;
/// A path shorter than this many widths covers less than the round ends of its neighbours leave.
constexpr double kMinLengthWidths = 1.0;
/// Beside walls, ends that no link leads on from come so much of the distance nearer that the
/// overlap leaves: gaps where a line meets the edge at a flat angle are smaller.
constexpr double kFreeShare = 0.25;
/// Links come nearer to the edge by so much of the overlap.
constexpr double kLinkOverlap = 0.07;
/// What links between curves may add to their length.
constexpr double kMostLinkShare = 0.01;
constexpr double kDepthPrecision = 0.001;  // of a spacing

/// How far from the region's edge lines end.
Coord EndDistance(Coord spacing, Coord overlap) {
  return std::max<Coord>(0, spacing / 2 - overlap);
}

/// How far from the region's edge lines end: those that links join, and the others.
struct EndDistances {
  Coord linked_nm = 0;
  Coord free_nm = 0;
};

EndDistances EndsOf(Coord spacing, const SolidFill& fill, bool linked) {
  if (fill.anchored) return {};
  const Coord full = EndDistance(spacing, fill.overlap_nm);
  if (!fill.beside_walls) return {full, full};
  const auto free = static_cast<Coord>(kFreeShare * static_cast<double>(full));
  if (!linked) return {free, free};
  const auto overlap = static_cast<Coord>(kLinkOverlap * static_cast<double>(fill.overlap_nm));
  return {std::max(free, EndDistance(spacing, overlap)), free};
}

/// Lines across an area, the outermost ones `margin` inside of it, if that takes no more stretch
/// than allowed; else as many as come nearest, in its middle.
LineFamily FittingLines(const MultiPolygon& area, double angle_rad, double spacing, double margin) {
  const FrameBox extent = BoxIn(LineAxes(angle_rad), area);
  const double height = extent.max_v - extent.min_v - 2 * margin + spacing;
  const double count = std::max(1.0, std::round(height / spacing));
  const double pitch = std::clamp(height / count, kLeastStretch * spacing, kMostStretch * spacing);
  return {angle_rad, (extent.min_v + extent.max_v) / 2 - (count - 1) / 2 * pitch, pitch};
}

/// One line across an area that lies between two of the family.
LineFamily MiddleLine(const MultiPolygon& area, LineFamily family) {
  const FrameBox extent = BoxIn(LineAxes(family.angle_rad), area);
  family.phase_nm = (extent.min_v + extent.max_v) / 2;
  return family;
}

/// Half the width of a region's widest place, to `precision`.
double DepthOf(const MultiPolygon& region, double at_most, double precision) {
  double low = 0, high = at_most;
  while (high - low > precision) {
    const double middle = (low + high) / 2;
    (FastOffset(region, -std::llround(middle)).empty() ? high : low) = middle;
  }
  return high;
}

/// The distance of loops that leave no room in the middle.
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
  const Coord inset = EndsOf(nominal, fill, linked).linked_nm;
  MultiPolygon area = FastOffset({region}, -inset);
  if (area.empty()) return FillGroup{};
  const auto wanted = static_cast<double>(nominal);
  const LineFamily family =
      FittingLines(area, fill.angle_rad, wanted, wanted / 2 - static_cast<double>(inset));
  const Coord spacing = std::llround(family.pitch_nm);
  const EndDistances ends = EndsOf(spacing, fill, linked);
  if (ends.linked_nm != inset) area = FastOffset({region}, -ends.linked_nm);
  auto lines = CutLines(area, family);
  if (lines.ok() && lines->PieceCount() == 0) lines = CutLines(area, MiddleLine(area, family));
  if (!lines.ok()) return lines.status();

  FillGroup group;
  group.keep_order = !linked || fill.pattern == FillPattern::kMonotonic;
  SerpentineOptions options{
      .monotonic = group.keep_order,
      .max_link_nm = linked ? kMaxLinkSpacings * family.pitch_nm : 0,
      .min_length_nm =
          kMinLengthWidths * static_cast<double>(WidthForSpacing(spacing, fill.height_nm)) -
          2 * static_cast<double>(ends.linked_nm - ends.free_nm)};
  std::vector<SerpentinePath> paths = Serpentine(*lines, options);
  // A place of its own with short lines only is not the ends of its neighbours'.
  if (paths.empty() && Area(region) >= wanted * wanted) {
    options.min_length_nm = 0;
    paths = Serpentine(*lines, options);
  }
  // A thread in the air is as thick as it leaves the nozzle, and without walls the lines' ends are
  // the edge.
  const SolidBeads beads(region, *lines, paths,
                         {.fitted = fill.beside_walls && fill.feature != Feature::kBridgeInfill,
                          .linked_nm = static_cast<double>(ends.linked_nm),
                          .free_nm = static_cast<double>(ends.free_nm)});
  for (const SerpentinePath& line : paths) {
    Path& path = group.paths.emplace_back(
        PathOfStrip(EvenRamps(beads.BeadOf(line), family.pitch_nm), fill.height_nm));
    path.feature = fill.feature;
    path.reversible = !group.keep_order;
  }
  return group;
}

absl::StatusOr<FillGroup> FillByCurves(const PolygonWithHoles& region, const SolidFill& fill) {
  auto pitch = static_cast<double>(Spacing(fill.width_nm, fill.height_nm));
  // Lines along the edge lie half a spacing from it by themselves, side by side with the wall: no
  // end of theirs needs to reach into it.
  const bool along_edge = InfoOf(fill.pattern).solid == SolidWay::kAlongEdge;
  const Coord inset = along_edge ? 0 : EndDistance(std::llround(pitch), fill.overlap_nm);
  const MultiPolygon area = FastOffset({region}, -inset);
  if (area.empty()) return FillGroup{};
  if (fill.pattern == FillPattern::kConcentric) pitch = FittingLoops(area, pitch);
  const Coord spacing = std::llround(pitch);
  const auto pieces =
      PatternOf(fill.pattern)(area, {0, fill.layer, pitch, fill.angle_rad, spacing});
  if (!pieces.ok()) return pieces.status();
  const Coord width = WidthForSpacing(spacing, fill.height_nm);
  FillGroup group;
  group.paths = LinkedPaths(area, *pieces,
                            {.width_nm = width,
                             .max_link_nm = kMaxLinkSpacings * pitch,
                             .budget_nm = kMostLinkShare * Area(region) / pitch,
                             .lifts_ends = false,
                             .min_length_nm = kMinLengthWidths * static_cast<double>(width)});
  for (Path& path : group.paths) path.feature = fill.feature;
  return group;
}

}  // namespace

bool IsAligned(FillPattern pattern) {
  return pattern == FillPattern::kAlignedRectilinear || pattern == FillPattern::kZigzag;
}

absl::StatusOr<FillGroup> FillSolid(const PolygonWithHoles& region, const SolidFill& fill) {
  const bool lines = InfoOf(fill.pattern).solid == SolidWay::kLines;
  return lines ? FillByLines(region, fill) : FillByCurves(region, fill);
}

}  // namespace slicefarm::infill
