#include "services/infill/algo/solid.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/lines/fitted_strips.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/scan_lines.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/linking/serpentine.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

constexpr double kLeastStretch = 0.85;
constexpr double kMostStretch = 1.2;
/// Ends that lie farther apart along the edge than this many spacings are not joined.
constexpr double kMaxLinkSpacings = 8.0;
/// A path shorter than this many widths covers less than the round ends of its neighbours leave.
constexpr double kMinLengthWidths = 1.0;
/// Beside walls, straight lines end at this share of the distance that the overlap leaves. Their
/// links hold what is missing there, so the volume is the same; but ends that are nearer leave
/// smaller gaps where a line meets the edge at a flat angle.
constexpr double kEndShare = 0.5;
/// Links are not made thinner than this many spacings.
constexpr double kLeastLinkSpacings = 0.1;
/// What links between curves may add to their length.
constexpr double kMostLinkShare = 0.01;
constexpr double kDepthPrecision = 0.001;  // of a spacing

/// How far from the region's edge lines end.
Coord EndDistance(Coord spacing, Coord overlap) {
  return std::max<Coord>(0, spacing / 2 - overlap);
}

/// Lines across a region that fill it from edge to edge, if that takes no more stretch than
/// allowed; else as many as come nearest, in its middle.
LineFamily FittingLines(const PolygonWithHoles& region, double angle_rad, double spacing) {
  const FrameBox extent = BoxIn(LineAxes(angle_rad), {region});
  const double height = extent.max_v - extent.min_v;
  const double count = std::max(1.0, std::round(height / spacing));
  const double pitch = std::clamp(height / count, kLeastStretch * spacing, kMostStretch * spacing);
  return {angle_rad, (extent.min_v + extent.max_v) / 2 - (count - 1) / 2 * pitch, pitch};
}

/// The strips of pieces of line: those that are fitted, but for such as a narrow bay or a leaning
/// edge would leave outside of the region.
class Strips {
 public:
  Strips(const PolygonWithHoles& region, FittedStrips fitted, FittedStrips even, Coord spacing)
      : edges_({region}, spacing), fitted_(std::move(fitted)), even_(std::move(even)) {}

  std::vector<StripPoint> From(int32_t place) const {
    std::vector<StripPoint> fitted = fitted_.From(place), even = even_.From(place);
    return fitted == even || StaysInside(fitted, even) ? fitted : even;
  }

 private:
  /// The middle of `even` lies in the region.
  bool StaysInside(const std::vector<StripPoint>& fitted,
                   const std::vector<StripPoint>& even) const {
    const auto leaves = [&](Point a, Point b) { return a != b && edges_.Meets(a, b); };
    if (leaves(even.front().at, fitted.front().at) || leaves(fitted.back().at, even.back().at))
      return false;
    for (size_t i = 1; i < fitted.size(); ++i)
      if (leaves(fitted[i - 1].at, fitted[i].at)) return false;
    return true;
  }

  EdgeIndex edges_;
  FittedStrips fitted_;
  FittedStrips even_;
};

/// The strips of a path's pieces, joined by links of one width: the width steps where two points
/// are equal.
Path MakePath(const SerpentinePath& line, const Strips& strips, Coord height, Coord link_width) {
  Path path;
  const auto append = [&](Point point, Coord width) {
    if (!path.points.empty() && path.points.back() == point && path.widths_nm.back() == width)
      return;
    path.points.push_back(point);
    path.widths_nm.push_back(width);
  };
  for (size_t k = 0; k < line.pieces.size(); ++k) {
    const std::vector<StripPoint> strip = strips.From(line.places[k]);
    if (k > 0) append(strip.front().at, link_width);
    for (const StripPoint& p : strip) append(p.at, WidthToFill(std::llround(p.strip_nm), height));
    if (k + 1 == line.pieces.size()) break;
    append(strip.back().at, link_width);
    for (int32_t i = line.pieces[k] + 2; i < line.pieces[k + 1]; ++i)
      append(line.points[i], link_width);
  }
  if (std::ranges::count(path.widths_nm, path.widths_nm[0]) == std::ssize(path.widths_nm))
    path.widths_nm.resize(1);
  return path;
}

/// By crossing, whether a link runs from it to the next one.
std::vector<bool> LinkedStretches(const ScanLines& lines, std::span<const SerpentinePath> paths) {
  std::vector<bool> linked(lines.crossings.size(), false);
  for (const SerpentinePath& path : paths)
    for (const int32_t from : path.stretches) linked[from] = true;
  return linked;
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
  const LineFamily family = FittingLines(
      region, fill.angle_rad, static_cast<double>(Spacing(fill.width_nm, fill.height_nm)));
  const Coord spacing = std::llround(family.pitch_nm);
  const double share = fill.beside_walls ? kEndShare : 1;
  const auto inset =
      static_cast<Coord>(share * static_cast<double>(EndDistance(spacing, fill.overlap_nm)));
  const MultiPolygon area = FastOffset({region}, -inset);
  const auto lines = CutLines(area, family);
  if (!lines.ok()) return lines.status();

  const Coord width = WidthForSpacing(spacing, fill.height_nm);
  const auto least_link = static_cast<Coord>(kLeastLinkSpacings * family.pitch_nm);
  const Coord link_width = WidthToFill(std::clamp(2 * inset, least_link, spacing), fill.height_nm);
  const bool linked = fill.pattern != FillPattern::kMonotonicLines;
  FillGroup group;
  group.keep_order = !linked || fill.pattern == FillPattern::kMonotonic;
  const SerpentineOptions options{.monotonic = group.keep_order,
                                  .max_link_nm = linked ? kMaxLinkSpacings * family.pitch_nm : 0,
                                  .min_length_nm = kMinLengthWidths * static_cast<double>(width)};
  const std::vector<SerpentinePath> paths = Serpentine(*lines, options);
  // A thread in the air is as thick as it leaves the nozzle, and without walls the lines' ends are
  // the edge.
  const bool fitted = fill.beside_walls && fill.feature != Feature::kBridgeInfill;
  const FittedStrips even(*lines);
  const Strips strips(
      region,
      fitted ? FittedStrips(*lines, LinkedStretches(*lines, paths), static_cast<double>(inset))
             : even,
      even, spacing);
  for (const SerpentinePath& line : paths) {
    Path& path = group.paths.emplace_back(MakePath(line, strips, fill.height_nm, link_width));
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
