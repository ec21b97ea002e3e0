#include "services/exposure/algo/scan/outline_check.h"

#include <cmath>

#include "services/exposure/algo/scan/border_grid.h"

namespace slicefarm::exposure {
namespace {

/// Returns true if a segment of a line is at a permitted position. `is_first`: the segment is the
/// line's first.
bool MayLie(const BorderGrid& border, Point a, Point b, double distance_nm, bool is_first) {
  if (distance_nm < 0) return border.Stays(a, b, -distance_nm);
  return is_first ? border.Keeps(a, b, distance_nm) : border.KeepsOn(a, b, distance_nm);
}

std::optional<StrayVector> FindStrayOf(const ExposureGroup& group, const BorderGrid& border,
                                       double distance_nm) {
  std::optional<StrayVector> stray;
  group.ForEachLine([&](std::span<const Point> line) {
    for (size_t i = 1; i < line.size() && !stray; ++i)
      if (!MayLie(border, line[i - 1], line[i], distance_nm, i == 1))
        stray = {group.kind, line[i - 1], line[i]};
  });
  return stray;
}

}  // namespace

std::optional<StrayVector> FindStray(std::span<const ExposureGroup> groups,
                                     const MultiPolygon& outline, const ExposureOptions& options) {
  if (groups.empty()) return std::nullopt;
  // Contours without compensation are on the outline itself except for rounding. The required
  // distance is then negative: they may be outside by this much.
  const auto kept = static_cast<double>(options.beam_compensation_nm - kStrayNm);
  const BorderGrid border(outline, std::abs(kept));
  for (const ExposureGroup& group : groups) {
    const bool is_thin = group.kind == ExposureKind::kThinWall;
    if (const auto stray = FindStrayOf(group, border, is_thin ? 0 : kept)) return stray;
  }
  return std::nullopt;
}

}  // namespace slicefarm::exposure
