#include "services/infill/algo/fields/field_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/fields/dither.h"
#include "services/infill/algo/fields/graded_lines.h"
#include "services/infill/algo/fields/streamlines.h"
#include "services/infill/algo/patterns/line_families.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Smallest length of a piece of a graded line, in spacings. A shorter piece is not worth a start
/// and an end.
constexpr double kShortest = 4;
/// Smallest density for which streamlines are laid out. Below it, beads would be several
/// centimetres apart.
constexpr double kThinnest = 0.01;
/// Side of the grid to which boxes of streamlines are extended, in mm. Layers of similar extent
/// therefore have the same box.
constexpr double kBoxMm = 8;
/// Distance in nm within which a point is on a region's boundary. Parts are cut out of their region
/// with an error of some nanometres.
constexpr Coord kOnEdgeNm = 1'000;
/// Size of the squares in which a region's edges are indexed.
constexpr Coord kSquareNm = kNmPerMm;

/// Returns families that shift with the height at 45 degrees, alternately to either side. Each line
/// is supported by the line below. Over a few pitches of height, each point has had lines of all
/// ranks.
std::vector<LineFamily> Leaning(std::vector<LineFamily> families, Coord z_nm) {
  double side = 1;
  for (LineFamily& family : families) {
    family.phase_nm += side * static_cast<double>(z_nm);
    side = -side;
  }
  return families;
}

StreamBox BoxAround(const MultiPolygon& region) {
  const Box box = Bounds(region);
  const auto down = [](Coord at) {
    return std::floor(ToMm(static_cast<double>(at)) / kBoxMm) * kBoxMm;
  };
  return {down(box.min.x), down(box.min.y), down(box.max.x) + kBoxMm, down(box.max.y) + kBoxMm};
}

absl::StatusOr<std::vector<Curve>> StreamCurves(const StreamBox& box, Coord spacing_nm,
                                                const LayerField& field) {
  const double spacing_mm = ToMm(static_cast<double>(spacing_nm));
  const StreamOptions options{
      .z_mm = field.z_mm, .across = field.across, .separation_mm = [&](double x_mm, double y_mm) {
        const double density = std::min(1.0, field.DensityAt(x_mm, y_mm));
        return density < kThinnest ? 0 : spacing_mm / density;
      }};
  return Streamlines(box, *field.directions, options);
}

absl::StatusOr<std::vector<Piece>> StreamPieces(const MultiPolygon& region, Coord spacing_nm,
                                                const LayerField& field) {
  StreamMemo own;
  StreamMemo& memo = field.memo != nullptr ? *field.memo : own;
  const StreamBox box = BoxAround(region);
  if (memo.spacing_nm != spacing_nm || memo.box != box) {
    auto curves = StreamCurves(box, spacing_nm, field);
    if (!curves.ok()) return curves.status();
    memo = {box, spacing_nm, *std::move(curves)};
  }
  return ClipCurves(region, memo.curves);
}

/// Returns the position of a point on the edges of a region, or a position without a ring if no
/// edge is near.
EdgePosition PlaceOn(const EdgeIndex& edges, Point p) {
  EdgePosition position;
  double nearest = kOnEdgeNm;
  edges.ForEachNear(Box{p, p}.Grown(kOnEdgeNm), [&](int32_t number) {
    const EdgeIndex::Edge& edge = edges.At(number);
    const double distance = DistanceToSegment(p, edge.a, edge.b);
    if (distance > nearest) return;
    if (distance == nearest && position.ring >= 0) return;
    nearest = distance;
    position = {edge.ring, edge.edge};
  });
  return position;
}

/// Returns a part without a margin of `free_nm` along its border with neighbour parts, so that
/// curves along the part's boundary keep this distance from the neighbours.
MultiPolygon BesideOthers(const MultiPolygon& region, const MultiPolygon& part, double free_nm) {
  const MultiPolygon others = Difference(region, part);
  return others.empty() ? part : Difference(part, FastOffset(others, std::llround(free_nm)));
}

absl::StatusOr<std::vector<Piece>> PiecesInParts(const MultiPolygon& region, FillPattern pattern,
                                                 PatternContext context, const LayerField& field) {
  const auto parts = PartsOfField(region, field);
  if (!parts.ok()) return parts.status();
  const EdgeIndex edges(region, kSquareNm);
  std::vector<Piece> all;
  for (const DensityPart& part : *parts) {
    context.pitch_nm = static_cast<double>(context.spacing_nm) / std::min(1.0, part.density);
    const bool is_along_edge = InfoOf(pattern).solid == SolidFillStyle::kAlongEdge;
    auto pieces = PatternOf(pattern)(
        is_along_edge ? BesideOthers(region, part.area, context.pitch_nm / 2) : part.area, context);
    if (!pieces.ok()) return pieces.status();
    for (Piece& piece : *pieces) {
      if (piece.closed) continue;
      if (piece.from.ring >= 0) piece.from = PlaceOn(edges, piece.points.front());
      if (piece.to.ring >= 0) piece.to = PlaceOn(edges, piece.points.back());
    }
    std::ranges::move(*pieces, std::back_inserter(all));
  }
  return all;
}

}  // namespace

bool IsInParts(FillPattern pattern, const LayerField& field) {
  if (field.directions != nullptr) return false;
  // A layer of this pattern has one family of lines or two, so only all of its layers together have
  // the mean density. Graded lines give each layer the mean density.
  if (pattern == FillPattern::kLateralHoneycomb) return true;
  return field.density->dither != Dither::kNone ||
         LineFamiliesOf(pattern, {.pitch_nm = kNmPerMm}).empty();
}

absl::StatusOr<std::vector<DensityPart>> PartsOfField(const MultiPolygon& region,
                                                      const LayerField& field) {
  const DensityField& density = *field.density;
  if (density.dither == Dither::kNone) return LevelParts(region, field, density.cell_mm);
  const double greatest = density.Greatest();
  auto cells = DitheredRegion(region, field, density.dither, greatest, density.cell_mm);
  if (!cells.ok()) return cells.status();
  return std::vector<DensityPart>{{*std::move(cells), greatest}};
}

absl::StatusOr<std::vector<Piece>> PiecesOfField(const MultiPolygon& region, FillPattern pattern,
                                                 const PatternContext& context,
                                                 const LayerField& field) {
  if (region.empty()) return std::vector<Piece>{};
  if (field.directions != nullptr) return StreamPieces(region, context.spacing_nm, field);
  if (IsInParts(pattern, field)) return PiecesInParts(region, pattern, context, field);
  const double greatest = field.density->Greatest();
  if (greatest <= 0) return std::vector<Piece>{};
  const auto spacing = static_cast<double>(context.spacing_nm);
  PatternContext upright = context;  // all graded lines lean alike, no pattern by itself
  upright.pitch_nm = spacing / greatest;
  upright.z_nm = 0;
  return GradedPieces(region, Leaning(LineFamiliesOf(pattern, upright), context.z_nm), field,
                      {.greatest = greatest, .min_length_nm = kShortest * spacing});
}

}  // namespace slicefarm::infill
