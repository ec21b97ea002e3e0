#include "services/infill/algo/sparse.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/fields/field_pieces.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Links are left out where they bring a region's plastic this far over what its density asks for.
constexpr double kMostExcess = 0.01;
/// Thinner links than this share of a bead would not hold.
constexpr double kLeastFlow = 0.3;
/// The band along the edge in which links may change the pattern, in widths.
constexpr double kBandWidths = 2;
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

double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces) {
    for (size_t i = 1; i < piece.points.size(); ++i)
      length += Distance(piece.points[i - 1], piece.points[i]);
    if (piece.closed) length += Distance(piece.points.back(), piece.points.front());
  }
  return length;
}

/// What the links may add to the length of the pieces: the pattern's length over the whole region,
/// and `excess` of it more, less that of the pieces.
double LinkBudget(const MultiPolygon& region, const MultiPolygon& area, const SparseFill& fill,
                  double pitch, const std::vector<Piece>& pieces, double excess) {
  if (IsByLaw(fill)) return ((1 + excess) * Area(region) - Area(area)) / pitch;
  const double whole = Area(area);
  return whole <= 0 ? 0 : ((1 + excess) * Area(region) / whole - 1) * LengthOf(pieces);
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
  const MultiPolygon area = FastOffset(region, -inset);
  const double pitch = static_cast<double>(spacing) / std::min(1.0, fill.density);
  const auto pieces = PiecesOf(
      fill, area,
      {fill.z_nm, fill.layer, pitch, fill.angle_rad, spacing, fill.planned, fill.smoothing_nm});
  if (!pieces.ok()) return pieces.status();
  const auto width = static_cast<double>(fill.width_nm);
  // A link lies beside a wall, which has taken the part of its bead that overlaps.
  const double room = static_cast<double>(spacing) / 2 + static_cast<double>(inset);
  paths =
      LinkedPaths(area, *pieces,
                  {.width_nm = fill.width_nm,
                   .height_nm = fill.height_nm,
                   .max_link_nm = static_cast<double>(fill.anchor_max_nm),
                   .anchor_nm = static_cast<double>(std::min(fill.anchor_nm, fill.anchor_max_nm)),
                   .most_cut_nm = kBandWidths * width - static_cast<double>(inset),
                   .budget_nm = LinkBudget(region, area, fill, pitch, *pieces, kMostExcess),
                   .aim_nm = LinkBudget(region, area, fill, pitch, *pieces, 0),
                   .most_flow = std::min(1.0, room / static_cast<double>(spacing)),
                   .least_flow = kLeastFlow,
                   .min_length_nm = (IsByLaw(fill) ? kMinLoneWidths : kMinPieceWidths) * width});
  for (Path& path : paths) path.feature = Feature::kInternalInfill;
  return paths;
}

}  // namespace slicefarm::infill
