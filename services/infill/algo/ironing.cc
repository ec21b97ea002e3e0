#include "services/infill/algo/ironing.h"

#include <utility>

#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/lines/scan_lines.h"
#include "services/infill/algo/linking/serpentine.h"

namespace slicefarm::infill {
namespace {

/// Largest distance along the region's boundary, in spacings, between two ends that are joined.
/// Over a longer distance the nozzle would drag along the boundary.
constexpr double kIroningLinkSpacings = 3;

}  // namespace

absl::StatusOr<FillGroup> IronedLines(const MultiPolygon& region, const IroningFill& fill) {
  const MultiPolygon area = FastOffset(region, -fill.ironing.spacing_nm / 2);
  const auto spacing = static_cast<double>(fill.ironing.spacing_nm);
  const auto lines = CutLines(area, {fill.angle_rad, 0, spacing});
  if (!lines.ok()) return lines.status();
  const auto strip = static_cast<Coord>(fill.ironing.flow * spacing);
  const Coord width = std::max<Coord>(1, WidthToFill(strip, fill.height_nm));
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
