#include "services/infill/algo/sparse.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/fields/field_pieces.h"
#include "services/infill/algo/fields/mean_density.h"
#include "services/infill/algo/lines/line_flow.h"
#include "services/infill/algo/lines/rounded_corners.h"
#include "services/infill/algo/linking/linked_paths.h"
#include "services/infill/algo/linking/taken_edge.h"
#include "services/infill/algo/patterns/side_by_side.h"

namespace slicefarm::infill {
namespace {

/// Limits for joining two ends inside a region: their largest distance, in pitches, and the largest
/// added length as a share of this distance. In an octree, ends at larger planes are beside each
/// other along these planes. Where parts of a field meet, ends face each other, and the density
/// must be correct at each point.
constexpr double kReachInOctree = 8, kAddedInOctree = 0.9;
constexpr double kReachInField = 4, kAddedInField = 0.25;
/// Smallest length of a path of planned patterns or fields, in widths. A shorter path supports
/// nothing.
constexpr double kMinPieceWidths = 1;

/// Largest relative change of the beads' plastic if the cells of a dithered field do not have the
/// requested density. Smooth surfaces have up to 15 % more lines in some layers than in others. A
/// larger difference means a region of a few cells, each of which is on or off.
constexpr double kMostSettled = 0.15;

absl::StatusOr<std::vector<Piece>> PiecesOf(const SparseFill& fill, const MultiPolygon& area,
                                            const PatternContext& context) {
  if (fill.field == nullptr) {
    auto pieces = PiecesOfPattern(fill.pattern, area, context);
    if (pieces.ok() && fill.shape.smooth > 0 && HasSmoothCorners(fill.pattern))
      RoundCorners(area, fill.shape.smooth, *pieces);
    return pieces;
  }
  PatternContext single = context;  // fields have no lines side by side
  single.shape.lines = 1;
  return PiecesOfField(area, fill.pattern, single, *fill.field);
}

/// Returns an island's area inset by `inset_nm`, or nullopt if the island may be narrow somewhere.
/// It is nowhere narrow if a further inset by `half_nm` changes the lengths of its edges, but not
/// their number.
std::optional<PolygonWithHoles> WideArea(const PolygonWithHoles& island, Coord inset_nm,
                                         Coord half_nm) {
  const auto core = TryOffset({island}, -(inset_nm + half_nm));
  if (!core || core->has_tips) return std::nullopt;
  auto room = TryOffset({island}, -inset_nm);
  if (!room) return std::nullopt;
  const auto corners = [](const CleanOffset& offset) {
    size_t count = 0;
    ForEachRing(offset.polygons, [&](const Polygon& ring) { count += ring.size(); });
    return count;
  };
  if (corners(*core) != corners(*room)) return std::nullopt;
  return std::move(room->polygons[0]);
}

/// Returns the area for lines, `inset_nm` from the region's boundary, without parts where beads
/// along both sides would overlap. Corners of the remaining area are mitered, also beyond edges
/// that disappear in the inset.
MultiPolygon ClearanceFor(const MultiPolygon& region, Coord inset_nm, Coord width_nm) {
  const auto half = static_cast<Coord>(kLeastApart / 2 * static_cast<double>(width_nm));
  MultiPolygon room, others;
  for (const PolygonWithHoles& island : region) {
    auto wide = WideArea(island, inset_nm, half);
    wide ? room.push_back(*std::move(wide)) : others.push_back(island);
  }
  const MultiPolygon wide = FastOffset(FastOffset(others, -(inset_nm + half)), half);
  if (!wide.empty())
    std::ranges::move(Intersection(wide, FastOffset(others, -inset_nm)), std::back_inserter(room));
  Canonicalize(room);
  return room;
}

bool IsByLaw(const SparseFill& fill) {
  return fill.field == nullptr && !InfoOf(fill.pattern).planned;
}

/// Returns the mean density of the lines. Errors: REQUEST_TOO_LARGE, see MeanDensity.
absl::StatusOr<double> DensityOf(const SparseFill& fill, const MultiPolygon& area) {
  return fill.field == nullptr ? fill.density : MeanDensity(area, *fill.field);
}

/// Returns the limits of joints for lines that end inside a region: where parts of a field meet,
/// and at larger planes of an octree.
InnerJoints JointsOf(const SparseFill& fill, double pitch_nm) {
  const auto width = static_cast<double>(fill.width_nm);
  if (fill.field != nullptr && IsInParts(fill.pattern, *fill.field))
    return {kReachInField * pitch_nm, kAddedInField, width};
  if (fill.field == nullptr &&
      (fill.pattern == FillPattern::kAdaptiveCubic || fill.pattern == FillPattern::kSupportCubic))
    return {kReachInOctree * pitch_nm, kAddedInOctree, width};
  return {};
}

/// Returns the factor for the plastic of all beads that corrects the error of a dithered field:
/// whole cells are too many or too few, and their edges cut off lines.
double SettledShare(const SparseFill& fill, std::span<const Piece> pieces, double asked_nm) {
  if (fill.field == nullptr || fill.field->directions != nullptr ||
      fill.field->density->dither == Dither::kNone)
    return 1;
  double length = 0;
  for (const Piece& piece : pieces) {
    length += Length(piece.points);
    if (piece.closed) length += Distance(piece.points.back(), piece.points.front());
  }
  return length > 0 ? std::clamp(asked_nm / length, 1 - kMostSettled, 1 + kMostSettled) : 1;
}

}  // namespace

absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill) {
  std::vector<Path> paths;
  if (region.empty() || (fill.field == nullptr && fill.density <= 0)) return paths;
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  const Coord inset = std::max<Coord>(0, spacing / 2 - fill.overlap_nm);
  const MultiPolygon area = ClearanceFor(region, inset, fill.width_nm);
  if (area.empty()) return paths;
  const auto density = DensityOf(fill, area);
  if (!density.ok()) return density.status();
  if (*density <= 0) return paths;
  const double pitch = static_cast<double>(spacing) / std::min(1.0, *density);
  const auto pieces = PiecesOf(fill, area,
                               {fill.z_nm, fill.layer, pitch, fill.angle_rad, spacing, 0,
                                fill.planned, fill.smoothing_nm, fill.shape});
  if (!pieces.ok()) return pieces.status();
  const auto width = static_cast<double>(fill.width_nm);
  paths =
      LinkedPaths(area, *pieces,
                  {.width_nm = fill.width_nm,
                   .max_link_nm = static_cast<double>(fill.anchor_max_nm),
                   .anchor_nm = static_cast<double>(std::min(fill.anchor_nm, fill.anchor_max_nm)),
                   .min_length_nm = (IsByLaw(fill) ? kMinLoneWidths : kMinPieceWidths) * width,
                   .inner = JointsOf(fill, pitch),
                   .facing_nm = fill.pattern == FillPattern::kMedialAxis ? pitch : 0});
  const double share = SettledShare(fill, *pieces, Area(area) / pitch);
  const Coord settled =
      share == 1 ? fill.width_nm : WidthFor(share, fill.width_nm, fill.height_nm, fill.height_nm);
  for (Path& path : paths) {
    path.feature = Feature::kInternalInfill;
    path.widths_nm = {settled};
  }
  return paths;
}

}  // namespace slicefarm::infill
