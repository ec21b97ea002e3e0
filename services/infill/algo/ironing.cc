#include "services/infill/algo/ironing.h"

#include <algorithm>
#include <utility>

#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/lines/scan_lines.h"
#include "services/infill/algo/linking/serpentine.h"
#include "services/infill/algo/space_filling/depth_rings.h"

namespace slicefarm::infill {
namespace {

/// Largest distance along the region's boundary, in spacings, between two ends that are joined.
/// Over a longer distance the nozzle would drag along the boundary.
constexpr double kIroningLinkSpacings = 3;

}  // namespace

namespace {

double DirectionOf(const IroningFill& fill) {
  return std::max(0.0, fill.ironing.angle_rad) + (fill.ironing.fixed_angle ? 0 : fill.angle_rad);
}

Coord WidthOf(const IroningFill& fill) {
  const auto strip =
      static_cast<Coord>(fill.ironing.flow * static_cast<double>(fill.ironing.spacing_nm));
  return std::max<Coord>(1, WidthToFill(strip, fill.height_nm));
}

absl::StatusOr<FillGroup> IronedLoops(MultiPolygon area, const IroningFill& fill) {
  for (const PolygonWithHoles& island : area)
    if (absl::Status ok = CheckRingSpacing(island, fill.ironing.spacing_nm); !ok.ok()) return ok;
  FillGroup group{.keep_order = true, .paths = {}};
  for (; !area.empty(); area = FastOffset(area, -fill.ironing.spacing_nm)) {
    ForEachRing(area, [&](const Polygon& ring) {
      Path& path = group.paths.emplace_back();
      path.feature = Feature::kIroning;
      path.closed = true;
      path.points = ring;
      path.widths_nm = {WidthOf(fill)};
    });
  }
  return group;
}

}  // namespace

absl::StatusOr<FillGroup> IronedLines(const MultiPolygon& region, const IroningFill& fill) {
  const MultiPolygon area = FastOffset(region, -fill.ironing.spacing_nm / 2);
  if (fill.ironing.concentric) return IronedLoops(area, fill);
  const auto spacing = static_cast<double>(fill.ironing.spacing_nm);
  const auto lines = CutLines(area, {DirectionOf(fill), 0, spacing});
  if (!lines.ok()) return lines.status();
  const Coord width = WidthOf(fill);
  FillGroup group{.keep_order = true, .paths = {}};
  for (SerpentinePath& line :
       Serpentine(*lines, {.monotonic = true,
                          .max_link_nm = kIroningLinkSpacings * spacing,
                          .min_length_nm = static_cast<double>(fill.width_nm)})) {
    Path& path = group.paths.emplace_back();
    path.feature = Feature::kIroning;
    path.reversible = false;
    path.points = std::move(line.points);
    path.widths_nm = {width};
  }
  return group;
}

}  // namespace slicefarm::infill
