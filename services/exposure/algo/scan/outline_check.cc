#include "services/exposure/algo/scan/outline_check.h"

#include <algorithm>
#include <array>

#include "common/geometry/offset/clean_offset.h"
#include "services/exposure/algo/scan/border_grid.h"

namespace slicefarm::exposure {
namespace {

bool IsRings(ScanStrategy strategy) {
  return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
}

/// How far a kind's vectors are from the outline at least.
double KeptDistance(ExposureKind kind, const ExposureOptions& options) {
  const Coord outermost = options.beam_compensation_nm;
  const Coord innermost =
      outermost + std::max(0, options.contours - 1) * options.contour_distance_nm;
  switch (kind) {
    case ExposureKind::kContour:
      return static_cast<double>(outermost - kStrayNm);
    case ExposureKind::kThinWall:
      return 0;
    default:
      break;
  }
  return static_cast<double>(std::max(innermost, InsideInset(options)) - kStrayNm);
}

std::optional<StrayVector> FindStrayOf(const ExposureGroup& group, const BorderGrid& border,
                                       double distance_nm) {
  std::optional<StrayVector> stray;
  group.ForEachLine([&](std::span<const Point> line) {
    for (size_t i = 1; i < line.size() && !stray; ++i)
      if (!border.Keeps(line[i - 1], line[i], distance_nm))
        stray = {group.kind, line[i - 1], line[i]};
  });
  return stray;
}

}  // namespace

Coord InsideInset(const ExposureOptions& options) {
  const Coord inset = options.contours == 0
                          ? options.beam_compensation_nm
                          : options.beam_compensation_nm + options.hatch_offset_nm +
                                (options.contours - 1) * options.contour_distance_nm;
  if (!IsRings(options.strategy)) return inset;
  return inset - (options.hatch_distance_nm - options.ring_overlap_nm) / 2;
}

std::optional<StrayVector> FindStray(std::span<const ExposureGroup> groups,
                                     const MultiPolygon& outline, const ExposureOptions& options) {
  if (groups.empty()) return std::nullopt;
  std::array<double, kExposureKindCount> kept{};
  for (size_t kind = 0; kind < kept.size(); ++kind)
    kept[kind] = KeptDistance(static_cast<ExposureKind>(kind), options);
  // Contours without compensation lie on the outline itself, to a rounding.
  const bool grown = *std::ranges::min_element(kept) < 0;
  if (grown)
    for (double& distance : kept) distance += static_cast<double>(2 * kStrayNm);
  const double reach = *std::ranges::max_element(kept);
  const BorderGrid border(grown ? FastOffset(outline, 2 * kStrayNm) : outline, reach);
  for (const ExposureGroup& group : groups)
    if (const auto stray = FindStrayOf(group, border, kept[static_cast<size_t>(group.kind)]))
      return stray;
  return std::nullopt;
}

}  // namespace slicefarm::exposure
