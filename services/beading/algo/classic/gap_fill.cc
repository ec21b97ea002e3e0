#include "services/beading/algo/classic/gap_fill.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/simplify.h"
#include "common/model/bead_section.h"
#include "services/beading/algo/skeleton/medial_axis.h"

namespace slicefarm::beading {
namespace {

constexpr Coord kToleranceNm = 5'000;
/// Smaller beads are not worth their travel.
constexpr double kMinAreaNm2 = 0.02 * kNmPerMm * kNmPerMm;

Path MakePath(ThickLine line, bool along_outline, const GapFillOptions& options) {
  Path path;
  path.feature = Feature::kGapFill;
  path.closed = line.closed;
  path.points = std::move(line.points);
  path.widths_nm.reserve(line.thickness_nm.size());
  for (const Coord thickness : line.thickness_nm) {
    const Coord gap = std::min(thickness, options.max_width_nm);
    path.widths_nm.push_back(along_outline ? gap : WidthToFill(gap, options.layer_height_nm));
  }
  const auto [least, most] = std::minmax_element(path.widths_nm.begin(), path.widths_nm.end());
  if (*least == *most) path.widths_nm.resize(1);
  return path;
}

/// A region whose mean width is far below what is filled has no part that is wide enough, as
/// rounding slivers do.
bool IsSliver(const PolygonWithHoles& region, Coord min_width_nm) {
  const double area = Area(region);
  if (area < kMinAreaNm2) return true;
  double perimeter = Perimeter(region.outer);
  for (const Polygon& hole : region.holes) perimeter += Perimeter(hole);
  return 2 * area < perimeter * static_cast<double>(min_width_nm) / 8;
}

}  // namespace

absl::StatusOr<std::vector<Path>> FillGaps(const std::vector<Gap>& gaps,
                                           const GapFillOptions& options,
                                           const CancelToken& cancel) {
  const MedialAxisOptions axis{options.min_width_nm, kToleranceNm};
  std::vector<Path> paths;
  for (const Gap& gap : gaps) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    if (IsSliver(gap.region, options.min_width_nm)) continue;
    const MultiPolygon simple = Simplify({gap.region}, kToleranceNm);
    std::vector<ThickLine> lines;
    if (!simple.empty()) lines = MedialAxis(simple.front(), axis);
    // Simplifying can make rings cross; then the gap as it came may do.
    if (lines.empty()) lines = MedialAxis(gap.region, axis);
    for (ThickLine& line : lines) {
      if (Area(line) < kMinAreaNm2) continue;
      paths.push_back(MakePath(std::move(line), gap.along_outline, options));
    }
  }
  return paths;
}

}  // namespace slicefarm::beading
