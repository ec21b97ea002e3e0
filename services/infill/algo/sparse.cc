#include "services/infill/algo/sparse.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/between.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/fields/field_pieces.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/linking/taken_edge.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Of a part of a field, lines are no fewer than this share of what it asks for.
constexpr double kLeastLines = 0.3;
/// Parts are cut out of their region with an error of some nanometres.
constexpr Coord kOnEdgeNm = 1'000;
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

/// Which share of a part's edge lies inside the region.
double InnerShare(const EdgeIndex& edges, const MultiPolygon& part) {
  double inner = 0, all = 0;
  ForEachRing(part, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const Point middle = PointBetween(a, b, 0.5);
      bool on_edge = false;
      edges.ForEachNear(Box{middle, middle}.Grown(kOnEdgeNm), [&](int32_t number) {
        const EdgeIndex::Edge& edge = edges.At(number);
        on_edge = on_edge || DistanceToSegment(middle, edge.a, edge.b) <= kOnEdgeNm;
      });
      all += Distance(a, b);
      if (!on_edge) inner += Distance(a, b);
    }
  });
  return all > 0 ? inner / all : 0;
}

/// A part less a strip along the others, so that beads on both sides of the edge lie side by side.
MultiPolygon BesideOthers(const MultiPolygon& region, const MultiPolygon& part, Coord strip_nm) {
  const MultiPolygon others = Difference(region, part);
  if (others.empty() || strip_nm <= 0) return part;
  return Difference(part, FastOffset(others, strip_nm));
}

/// Fills one part as dense as it is. What runs along its inner edges holds to no wall, so it
/// counts: lines are so much fewer.
absl::StatusOr<std::vector<Path>> FillPart(const DensityPart& part, const MultiPolygon& own,
                                           double inner_share, SparseFill fill) {
  fill.field = nullptr;
  fill.density = part.density;
  auto paths = FillSparse(own, fill);
  if (!paths.ok() || inner_share <= 0) return paths;
  double length = 0;
  for (const Path& path : *paths) length += PathLength(path);
  const auto spacing = static_cast<double>(Spacing(fill.width_nm, fill.height_nm));
  const double excess = length * spacing / Area(part.area) - part.density;
  fill.density = std::clamp(part.density - inner_share * excess, kLeastLines * part.density, 1.0);
  return FillSparse(own, fill);
}

/// Each part by itself.
absl::StatusOr<std::vector<Path>> FillParts(const MultiPolygon& region, const SparseFill& fill) {
  const auto parts = PartsOfField(region, *fill.field);
  if (!parts.ok()) return parts.status();
  const EdgeIndex edges(region, kNmPerMm);
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  std::vector<Path> all;
  for (const DensityPart& part : *parts) {
    const MultiPolygon own =
        BesideOthers(region, part.area, std::min(fill.overlap_nm, spacing / 2));
    auto paths = FillPart(part, own, InnerShare(edges, part.area), fill);
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
