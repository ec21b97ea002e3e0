#include "services/ordering/algo/near_links.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/geometry/point.h"
#include "common/model/bead_section.h"

namespace slicefarm::ordering {
namespace {

/// Shortest loop that a link may shorten, in multiples of the length by which it is shortened.
constexpr double kLeastLoop = 10;

bool IsLinked(Feature feature) {
  return feature == Feature::kExternalPerimeter || feature == Feature::kPerimeter ||
         feature == Feature::kGapFill || feature == Feature::kInternalInfill ||
         feature == Feature::kSolidInfill || feature == Feature::kSolidOverBridge;
}

/// Returns the feature of a link: the feature of the two paths that it joins. A link between
/// different features is gap fill. So is a link between outer walls, because each outer wall stays
/// a separate loop.
Feature FeatureOfLink(const Path& last, const Path& next) {
  return last.feature == next.feature && last.feature != Feature::kExternalPerimeter
             ? last.feature
             : Feature::kGapFill;
}

/// Returns true for two loops of support, such as the walls of a thick branch.
bool AreSupportLoops(const PrintedEnd& last, const Path& next) {
  return last.is_loop && next.closed && last.path.feature == next.feature &&
         (next.feature == Feature::kSupport || next.feature == Feature::kSupportInterface);
}

/// Returns true if the link is a bead as wide as the paths that it joins, so that the flow does not
/// change.
bool IsEven(const PrintedEnd& last, const Path& next) {
  return AreSupportLoops(last, next) || (last.path.feature == Feature::kInternalInfill &&
                                         next.feature == Feature::kInternalInfill);
}

Coord NarrowerWidth(const Path& last, const Path& next) {
  return std::min(last.closed ? last.WidthAt(0) : last.WidthAt(last.points.size() - 1),
                  next.WidthAt(0));
}

bool CanLoseEnd(const Path& path, double length_nm) {
  return path.feature != Feature::kExternalPerimeter && PathLength(path) >= kLeastLoop * length_nm;
}

/// Removes the last `length_nm` of a path. A closed path becomes open. REQUIRES: the path is
/// longer.
void CutEnd(double length_nm, Path& path) {
  const bool varies = path.widths_nm.size() > 1;
  if (path.closed) {
    path.points.push_back(path.points.front());
    if (varies) path.widths_nm.push_back(path.widths_nm.front());
    path.closed = false;
  }
  double last = 0;
  while (path.points.size() > 2 &&
         (last = Distance(path.points.back(), path.points[path.points.size() - 2])) <= length_nm) {
    length_nm -= last;
    path.points.pop_back();
    if (varies) path.widths_nm.pop_back();
  }
  const Point before = path.points[path.points.size() - 2];
  Point& end = path.points.back();
  last = Distance(before, end);
  if (last <= 0) return;
  const double share = length_nm / last;
  end = {end.x + std::llround(share * static_cast<double>(before.x - end.x)),
         end.y + std::llround(share * static_cast<double>(before.y - end.y))};
  if (varies) {
    const Coord width = path.widths_nm[path.widths_nm.size() - 2];
    Coord& end_width = path.widths_nm.back();
    end_width += std::llround(share * static_cast<double>(width - end_width));
  }
}

}  // namespace

std::optional<Path> LinkBetween(PrintedEnd last, Path& next, Coord height_nm,
                                const Barrier& edges) {
  const Path& before = last.path;
  const bool may_be =
      AreSupportLoops(last, next) || (IsLinked(before.feature) && IsLinked(next.feature));
  if (!may_be || before.tool != next.tool) return std::nullopt;
  const Point from = EndOf(before), to = StartOf(next);
  const Coord width = NarrowerWidth(before, next);
  const double step = Distance(from, to);
  if (step <= 0 || step > kMostLinkWidths * static_cast<double>(width) || edges.Parts(from, to))
    return std::nullopt;
  Path link;
  link.feature = FeatureOfLink(before, next);
  link.settings = before.settings;
  link.tool = before.tool;
  link.inset = std::max(before.inset, next.inset);
  link.reversible = false;
  const bool is_even = IsEven(last, next);
  const double cut = is_even ? step : kLinkFlow * step;
  if (last.is_loop && CanLoseEnd(before, cut)) {
    CutEnd(cut, last.path);
  } else if (next.closed && CanLoseEnd(next, cut)) {
    CutEnd(cut, next);
  }
  link.points = {EndOf(before), to};
  link.widths_nm = {width};
  if (is_even) return link;
  const double strip = static_cast<double>(Spacing(width, height_nm)) * cut /
                       Distance(link.points[0], link.points[1]);
  link.widths_nm = {WidthToFill(std::max<Coord>(1, std::llround(strip)), height_nm)};
  return link;
}

}  // namespace slicefarm::ordering
