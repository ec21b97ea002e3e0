#include "services/exposure/algo/scan/outline_check.h"

#include <algorithm>

#include "common/geometry/offset/clean_offset.h"
#include "services/exposure/algo/scan/border_grid.h"

namespace slicefarm::exposure {
namespace {

std::optional<StrayVector> FindStrayOf(const ExposureGroup& group, const BorderGrid& border,
                                       double distance_nm) {
  std::optional<StrayVector> stray;
  group.ForEachLine([&](std::span<const Point> line) {
    for (size_t i = 1; i < line.size() && !stray; ++i) {
      const bool keeps = i == 1 ? border.Keeps(line[0], line[1], distance_nm)
                                : border.KeepsOn(line[i - 1], line[i], distance_nm);
      if (!keeps) stray = {group.kind, line[i - 1], line[i]};
    }
  });
  return stray;
}

}  // namespace

std::optional<StrayVector> FindStray(std::span<const ExposureGroup> groups,
                                     const MultiPolygon& outline, const ExposureOptions& options) {
  if (groups.empty()) return std::nullopt;
  double kept = static_cast<double>(options.beam_compensation_nm - kStrayNm), thin_wall = 0;
  // Contours without compensation lie on the outline itself, to a rounding.
  const bool grown = kept < 0;
  if (grown) {
    kept += static_cast<double>(2 * kStrayNm);
    thin_wall += static_cast<double>(2 * kStrayNm);
  }
  const BorderGrid border(grown ? FastOffset(outline, 2 * kStrayNm) : outline,
                          std::max(kept, thin_wall));
  for (const ExposureGroup& group : groups) {
    const bool is_thin = group.kind == ExposureKind::kThinWall;
    if (const auto stray = FindStrayOf(group, border, is_thin ? thin_wall : kept)) return stray;
  }
  return std::nullopt;
}

}  // namespace slicefarm::exposure
