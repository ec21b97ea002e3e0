#include "services/infill/algo/sparse.h"

#include <algorithm>
#include <utility>

#include "common/geometry/clean_offset.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Links may bring a region's plastic this far over what its density asks for.
constexpr double kMostExcess = 0.025;
/// Thinner links than this share of a bead would not hold.
constexpr double kLeastFlow = 0.3;
/// The band along the edge in which links may change the pattern, in widths.
constexpr double kBandWidths = 2;
/// Pieces shorter than this many widths hold nothing.
constexpr double kMinLengthWidths = 1;

}  // namespace

absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill) {
  std::vector<Path> paths;
  if (region.empty() || fill.density <= 0) return paths;
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  const Coord inset = std::max<Coord>(0, spacing / 2 - fill.overlap_nm);
  const MultiPolygon area = FastOffset(region, -inset);
  const double pitch = static_cast<double>(spacing) / std::min(1.0, fill.density);
  const auto pieces = PatternOf(fill.pattern)(
      area, {fill.z_nm, fill.layer, pitch, fill.angle_rad, spacing});
  if (!pieces.ok()) return pieces.status();
  const auto width = static_cast<double>(fill.width_nm);
  // A link lies beside a wall, which has taken the part of its bead that overlaps.
  const double room = static_cast<double>(spacing) / 2 + static_cast<double>(inset);
  paths = LinkedPaths(
      area, *pieces,
      {.width_nm = fill.width_nm,
       .height_nm = fill.height_nm,
       .max_link_nm = static_cast<double>(fill.anchor_max_nm),
       .anchor_nm = static_cast<double>(std::min(fill.anchor_nm, fill.anchor_max_nm)),
       .most_cut_nm = kBandWidths * width - static_cast<double>(inset),
       .budget_nm = ((1 + kMostExcess) * Area(region) - Area(area)) / pitch,
       .most_flow = std::min(1.0, room / static_cast<double>(spacing)),
       .least_flow = kLeastFlow,
       .min_length_nm = kMinLengthWidths * width});
  for (Path& path : paths) path.feature = Feature::kInternalInfill;
  return paths;
}

}  // namespace slicefarm::infill
