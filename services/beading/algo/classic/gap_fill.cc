#include "services/beading/algo/classic/gap_fill.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/rings/simplify.h"
#include "common/model/bead_section.h"
#include "services/beading/algo/skeleton/medial_axis.h"

namespace slicefarm::beading {
namespace {

constexpr Coord kToleranceNm = 5'000;

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

/// Returns true if the region's mean width is far below the smallest width that is filled. Such a
/// region has no part that is wide enough; typical examples are rounding slivers.
bool IsSliver(const PolygonWithHoles& region, Coord min_width_nm) {
  double perimeter = Perimeter(region.outer);
  for (const Polygon& hole : region.holes) perimeter += Perimeter(hole);
  return 2 * Area(region) < perimeter * static_cast<double>(min_width_nm) / 8;
}

/// Returns the beads of a gap that cover at least `least_area_nm2` each.
std::vector<Path> FillGap(const Gap& gap, double least_area_nm2, const GapFillOptions& options) {
  if (Area(gap.region) < least_area_nm2 || IsSliver(gap.region, options.min_width_nm)) return {};
  const MedialAxisOptions axis{options.min_width_nm, kToleranceNm};
  const MultiPolygon simple = Simplify({gap.region}, kToleranceNm);
  std::vector<ThickLine> lines;
  if (!simple.empty()) lines = MedialAxis(simple.front(), axis);
  // Simplifying can make rings cross. The region without simplification may still work.
  if (lines.empty()) lines = MedialAxis(gap.region, axis);
  std::vector<Path> paths;
  for (ThickLine& line : lines) {
    if (Area(line) < least_area_nm2) continue;
    Path path = MakePath(std::move(line), gap.along_outline, options);
    if (PathLength(path) >= static_cast<double>(options.min_length_nm))
      paths.push_back(std::move(path));
  }
  return paths;
}

/// Adds the beads of an area's narrow parts to `paths`. Returns the remaining area, which gets
/// infill.
MultiPolygon TakeNarrowParts(const PolygonWithHoles& area, const GapFillOptions& options,
                             std::vector<Path>& paths) {
  const NarrowParts narrow = FindNarrowParts(area, options.max_width_nm, kLeastNeckNm2);
  const double least = narrow.are_all ? kLeastDotNm2 : kLeastNeckNm2;
  MultiPolygon taken;
  bool are_all = narrow.are_all;
  for (const PolygonWithHoles& part : narrow.parts) {
    if (options.among != nullptr && Intersection({part}, *options.among).empty()) {
      are_all = false;
      continue;
    }
    std::vector<Path> beads = FillGap({part, false}, least, options);
    if (!beads.empty()) taken.push_back(part);
    std::ranges::move(beads, std::back_inserter(paths));
  }
  if (are_all) return {};
  return taken.empty() ? MultiPolygon{area} : Difference({area}, taken);
}

}  // namespace

absl::StatusOr<std::vector<Path>> FillGaps(const std::vector<Gap>& gaps,
                                           const GapFillOptions& options,
                                           const CancelToken& cancel) {
  std::vector<Path> paths;
  for (const Gap& gap : gaps) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    std::ranges::move(FillGap(gap, kLeastDotNm2, options), std::back_inserter(paths));
  }
  return paths;
}

absl::StatusOr<std::vector<Path>> FillNarrowParts(const GapFillOptions& options,
                                                  const CancelToken& cancel,
                                                  MultiPolygon& fill_area) {
  std::vector<Path> paths;
  if (!options.narrow_parts) return paths;
  MultiPolygon left;
  for (const PolygonWithHoles& area : fill_area) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    MultiPolygon rest = TakeNarrowParts(area, options, paths);
    std::move(rest.begin(), rest.end(), std::back_inserter(left));
  }
  fill_area = std::move(left);
  return paths;
}

}  // namespace slicefarm::beading
