#include "services/infill/algo/sparse.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/fields/field_pieces.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/linking/taken_edge.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Pieces shorter than this many widths hold nothing.
constexpr double kMinPieceWidths = 1;
/// A lone path of a pattern by law is worth a travel from this many widths on: it would be a dot
/// in a corner, of 0.1 mm3 at most, which no wall and no line needs.
constexpr double kMinLoneWidths = 2.5;

absl::StatusOr<std::vector<Piece>> PiecesOf(const SparseFill& fill, const MultiPolygon& area,
                                            const PatternPlace& place) {
  if (fill.field != nullptr) return PiecesOfField(area, fill.pattern, place, *fill.field);
  return PatternOf(fill.pattern)(area, place);
}

bool IsByLaw(const SparseFill& fill) {
  return fill.field == nullptr && !InfoOf(fill.pattern).planned;
}

/// Each part by itself, as dense as it is.
absl::StatusOr<std::vector<Path>> FillParts(const MultiPolygon& region, const SparseFill& fill) {
  const auto parts = PartsOfField(region, *fill.field);
  if (!parts.ok()) return parts.status();
  std::vector<Path> all;
  for (const DensityPart& part : *parts) {
    SparseFill plain = fill;
    plain.field = nullptr;
    plain.density = part.density;
    auto paths = FillSparse(part.area, plain);
    if (!paths.ok()) return paths.status();
    std::ranges::move(*paths, std::back_inserter(all));
  }
  return all;
}

}  // namespace

absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill) {
  std::vector<Path> paths;
  if (region.empty() || (fill.field == nullptr && fill.density <= 0)) return paths;
  if (fill.field != nullptr && IsInParts(fill.pattern, *fill.field)) return FillParts(region, fill);
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  const Coord inset = std::max<Coord>(0, spacing / 2 - fill.overlap_nm);
  // Where beads along both sides would lie on each other, the walls do without.
  const auto half = static_cast<Coord>(kLeastApart / 2 * static_cast<double>(fill.width_nm));
  const MultiPolygon area = FastOffset(FastOffset(region, -(inset + half)), half);
  const double pitch = static_cast<double>(spacing) / std::min(1.0, fill.density);
  const auto pieces = PiecesOf(
      fill, area,
      {fill.z_nm, fill.layer, pitch, fill.angle_rad, spacing, 0, fill.planned, fill.smoothing_nm});
  if (!pieces.ok()) return pieces.status();
  const auto width = static_cast<double>(fill.width_nm);
  paths =
      LinkedPaths(area, *pieces,
                  {.width_nm = fill.width_nm,
                   .max_link_nm = static_cast<double>(fill.anchor_max_nm),
                   .anchor_nm = static_cast<double>(std::min(fill.anchor_nm, fill.anchor_max_nm)),
                   .min_length_nm = (IsByLaw(fill) ? kMinLoneWidths : kMinPieceWidths) * width,
                   .facing_nm = fill.pattern == FillPattern::kMedialAxis ? pitch : 0});
  for (Path& path : paths) path.feature = Feature::kInternalInfill;
  return paths;
}

}  // namespace slicefarm::infill
