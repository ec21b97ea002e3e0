#include "services/infill/algo/sparse_under.h"

#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Pitch that represents no infill at all, in beads: skins of this width over empty space are
/// bridges.
constexpr double kVoidPitchBeads = 5;

bool IsSolidLayer(const InfillOptions& options, int32_t layer) {
  return options.density > 0 && options.solid_every_layers > 0 &&
         layer % options.solid_every_layers == 0;
}

/// Returns true if the positions of the lines follow from a formula.
bool HasLaw(FillPattern pattern, const RegionView& region) {
  const FillPatternInfo& info = InfoOf(pattern);
  return region.options.density > 0 && !info.planned && info.solid != SolidWay::kAlongEdge &&
         (region.plan == nullptr || region.plan->combined.empty());
}

MultiPolygon BeadsOf(const std::vector<Piece>& pieces, Coord width_nm) {
  std::vector<Polyline> lines;
  for (const Piece& piece : pieces) {
    Polyline& line = lines.emplace_back(piece.points);
    if (piece.closed) line.push_back(piece.points.front());
  }
  return lines.empty() ? MultiPolygon{} : OffsetLines(lines, width_nm / 2, Cap::kButt);
}

/// Computes the lines of the sparse infill of a layer.
absl::Status LayOut(const SectionView& layer, const RegionView& region, SparseBelow& sparse) {
  const InfillOptions& options = region.options;
  const FillPattern pattern = region.plan == nullptr ? options.pattern : region.plan->pattern;
  sparse.pitch_nm = SparsePitchNm(options, layer.height_nm);
  if (!HasLaw(pattern, region)) return absl::OkStatus();
  const FillLineAngles angles = AnglesOf(options, layer.layer);
  const auto pieces =
      PatternOf(pattern)(sparse.region, {.z_nm = layer.z_nm,
                                         .layer = angles.sparse_planned ? 0 : layer.layer,
                                         .pitch_nm = sparse.pitch_nm,
                                         .angle_rad = angles.sparse_rad,
                                         .spacing_nm = Spacing(options.sparse_width_nm, layer.height_nm),
                                         .smoothing_nm = options.smoothing_nm});
  if (!pieces.ok()) return pieces.status();
  sparse.beads = BeadsOf(*pieces, options.sparse_width_nm);
  return absl::OkStatus();
}

}  // namespace

double SparsePitchNm(const InfillOptions& options, Coord height_nm) {
  const auto spacing = static_cast<double>(Spacing(options.sparse_width_nm, height_nm));
  return options.density > 0 ? spacing / options.density : kVoidPitchBeads * spacing;
}

absl::StatusOr<SparseBelow> SparseUnder(const MultiPolygon& fill_area, const RegionView& region) {
  SectionView below = region.section;
  --below.layer;
  const ObjectSection* section = below.stacks.Find(below.stack.id, below.layer);
  const MultiPolygon* outline = below.OutlineAt(below.layer, region.row);
  SparseBelow sparse;
  if (section == nullptr || outline == nullptr) return sparse;
  below.z_nm = section->z_nm - section->height_nm / 2;
  below.height_nm = section->height_nm;
  const InfillOptions& options = region.options;
  sparse.region = PartFillArea(fill_area, *outline, CoverOf(below, options, region.row),
                               {.width_nm = options.solid_width_nm,
                                .solid_below_area_mm2 = options.solid_below_area_mm2,
                                .all_solid = IsSolidLayer(options, below.layer),
                                .shells = options.shells})
                      .sparse;
  const MultiPolygon* above = below.OutlineAt(region.section.layer, region.row);
  if (above == nullptr || *above != *outline)
    sparse.region = Intersection(sparse.region, FastOffset(*outline, -options.walls_nm));
  if (sparse.region.empty()) return sparse;
  if (absl::Status ok = LayOut(below, region, sparse); !ok.ok()) return ok;
  return sparse;
}

}  // namespace slicefarm::infill
