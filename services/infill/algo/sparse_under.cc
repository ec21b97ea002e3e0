#include "services/infill/algo/sparse_under.h"

#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/patterns/side_by_side.h"

namespace slicefarm::infill {
namespace {

/// Pitch that stands for layers without sparse infill, in spacings: wider skins over empty space
/// are bridges.
constexpr double kVoidPitchBeads = 5;

/// Returns true if the positions of the lines follow from a formula.
bool HasLaw(FillPattern pattern, const RegionView& region) {
  const FillPatternInfo& info = InfoOf(pattern);
  return region.options.density > 0 && !info.planned && info.solid != SolidFillStyle::kAlongEdge &&
         pattern != FillPattern::kLockedZag &&
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

}  // namespace

double SparsePitchNm(const InfillOptions& options, Coord height_nm) {
  const auto spacing = static_cast<double>(Spacing(options.sparse_width_nm, height_nm));
  const int32_t lines = LinesOf(options, options.pattern);
  return options.density > 0 ? lines * spacing / LeastDensity(options) : kVoidPitchBeads * spacing;
}

double LeastBridgedGapNm(const InfillOptions& options, Coord height_nm) {
  switch (options.solid.bridges) {
    case SparseBridgeFilter::kWide:
      return SparsePitchNm(options, height_nm);
    case SparseBridgeFilter::kMedium:
      return SparsePitchNm(options, height_nm) / 2;
    case SparseBridgeFilter::kAll:
      break;
  }
  return 0;
}

SparseUnder::SparseUnder(const RegionView& region)
    : region_(region),
      below_(region.section.Below()),
      outline_(below_.OutlineAt(below_.layer, region.row)) {
  if (outline_ == nullptr) return;
  const MultiPolygon* above = below_.OutlineAt(region.section.layer, region.row);
  same_outline_ = above != nullptr && *above == *outline_;
  cover_ = CoverOf(below_, region.options, region.row);
  near_cover_.emplace(cover_, outline_);
}

const MultiPolygon& SparseUnder::WithinWalls() {
  if (!within_walls_) within_walls_ = FastOffset(*outline_, -region_.options.walls_nm);
  return *within_walls_;
}

SparseBelow SparseUnder::Within(const MultiPolygon& fill_area, const MultiPolygon& wanted) {
  SparseBelow sparse;
  if (outline_ == nullptr) return sparse;
  const InfillOptions& options = region_.options;
  sparse.pitch_nm = SparsePitchNm(options, below_.height_nm);
  sparse.least_gap_nm = LeastBridgedGapNm(options, below_.height_nm);
  sparse.region = SparsePart(fill_area, *outline_, near_cover_->Near(Bounds(fill_area)),
                             {.width_nm = options.solid_width_nm,
                              .solid_below_area_mm2 = options.solid_below_area_mm2,
                              .all_solid = options.density > 0 && IsAllSolid(options, below_.layer),
                              .shells = options.shells},
                             wanted);
  if (!sparse.region.empty() && !same_outline_)
    sparse.region = Intersection(sparse.region, WithinWalls());
  return sparse;
}

absl::StatusOr<MultiPolygon> SparseUnder::BeadsIn(const SparseBelow& sparse, Point middle) const {
  const InfillOptions& options = region_.options;
  const FillPattern pattern = region_.plan == nullptr ? options.pattern : region_.plan->pattern;
  if (!HasLaw(pattern, region_)) return MultiPolygon{};
  const FillLineAngles angles = AnglesOf(options, below_.layer);
  const auto pieces = PiecesOfPattern(
      pattern, middle == Point{} ? sparse.region : Moved(sparse.region, Point{} - middle),
      {.z_nm = below_.z_nm,
       .layer = PatternLayer(pattern, angles, below_.layer),
       .pitch_nm = sparse.pitch_nm / LinesOf(options, options.pattern),
       .angle_rad = angles.sparse_rad,
       .spacing_nm = Spacing(options.sparse_width_nm, below_.height_nm),
       .smoothing_nm = options.smoothing_nm,
       .shape = options.shape});
  if (!pieces.ok()) return pieces.status();
  MultiPolygon beads = BeadsOf(*pieces, options.sparse_width_nm);
  return middle == Point{} ? std::move(beads) : Moved(std::move(beads), middle);
}

absl::StatusOr<SparseBridges> SparseUnder::TakeBridges(const MultiPolygon& fill_area,
                                                       const MultiPolygon& middles, Coord width_nm,
                                                       Point middle, Skins& skins) {
  SparseBelow below = Within(fill_area, middles);
  MultiPolygon unheld = UnheldParts(below, width_nm, skins);
  if (unheld.empty()) return SparseBridges{};
  auto beads = BeadsIn(below, middle);
  if (!beads.ok()) return beads.status();
  below.beads = *std::move(beads);
  return TakeSparseBridges(std::move(unheld), below, width_nm, skins);
}

}  // namespace slicefarm::infill
