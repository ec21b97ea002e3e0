#include "services/infill/algo/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/geometry/offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/scan_lines.h"
#include "services/infill/algo/serpentine.h"

namespace slicefarm::infill {
namespace {

constexpr double kLeastStretch = 0.85;
constexpr double kMostStretch = 1.2;
/// Ends that lie farther apart along the edge than this many spacings are not joined.
constexpr double kMaxLinkSpacings = 3.0;
constexpr double kMinLengthWidths = 0.5;

/// Lines across a region that fill it from edge to edge, if that takes no more stretch than
/// allowed; else as many as come nearest, in its middle.
LineFamily FittingLines(const PolygonWithHoles& region, double angle_rad, double spacing) {
  const Extent extent = ExtentAcross({region}, LineFrame(angle_rad));
  const double height = extent.max_v - extent.min_v;
  const double count = std::max(1.0, std::round(height / spacing));
  const double pitch = std::clamp(height / count, kLeastStretch * spacing, kMostStretch * spacing);
  return {angle_rad, (extent.min_v + extent.max_v) / 2 - (count - 1) / 2 * pitch, pitch};
}

}  // namespace

absl::StatusOr<FillGroup> FillSolid(const PolygonWithHoles& region, const SolidFill& fill) {
  const double angle = fill.angle_rad + (fill.layer_index % 2 != 0 ? std::numbers::pi / 2 : 0);
  const auto spacing = static_cast<double>(Spacing(fill.width_nm, fill.height_nm));
  const LineFamily family = FittingLines(region, angle, spacing);
  const Coord width = WidthForSpacing(std::llround(family.pitch_nm), fill.height_nm);
  const Coord inset = std::max<Coord>(0, width / 2 - fill.overlap_nm);
  const MultiPolygon area = Offset({region}, -inset);
  const auto lines = CutLines(area, family);
  if (!lines.ok()) return lines.status();
  FillGroup group;
  group.keep_order = fill.pattern == SolidPattern::kMonotonic;
  const SerpentineOptions options{.monotonic = group.keep_order,
                                  .max_link_nm = kMaxLinkSpacings * family.pitch_nm,
                                  .min_length_nm = kMinLengthWidths * static_cast<double>(width)};
  for (Polyline& line : Serpentine(*lines, options)) {
    Path& path = group.paths.emplace_back();
    path.feature = fill.feature;
    path.reversible = !group.keep_order;
    path.points = std::move(line);
    path.widths_nm = {width};
  }
  return group;
}

}  // namespace slicefarm::infill
