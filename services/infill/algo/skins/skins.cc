#include "services/infill/algo/skins/skins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"
#include "services/infill/algo/skins/region_mask.h"
#include "services/infill/algo/skins/smooth_offset.h"

namespace slicefarm::infill {
namespace {

/// How far skins reach into the sparse region, and bridges onto what bears them, in beads.
constexpr Coord kAnchorBeads = 2;

/// SmoothOffset with round corners, to 2 % of the distance: what miters reach jumps with an angle, at
/// tips of 60 degrees.
MultiPolygon RoundOffset(const MultiPolygon& region, Coord distance_nm) {
  return Offset(Simplify(region, kNoiseNm), distance_nm,
                {.join = Join::kRound, .arc_tolerance_nm = distance_nm / 50});
}

/// The part of `region` that is at least `width_nm` wide.
MultiPolygon WithoutSlivers(const MultiPolygon& region, Coord width_nm) {
  const MultiPolygon core = SmoothOffset(region, -width_nm / 2);
  if (core.empty()) return {};
  // Tips of what lies beyond the grown core are noise to SmoothOffset.
  return Intersection(region, SmoothOffset(core, width_nm / 2 + kNoiseNm / 2));
}

/// Drops islands that are smaller than a dot of a bead.
void EraseSpecks(MultiPolygon& region, Coord width_nm) {
  const double least = static_cast<double>(width_nm) * static_cast<double>(width_nm);
  std::erase_if(region, [least](const PolygonWithHoles& island) { return Area(island) < least; });
}

bool IsAir(const MultiPolygon* layer) { return layer == nullptr || layer->empty(); }

bool HasAir(const std::vector<const MultiPolygon*>& layers) {
  return std::any_of(layers.begin(), layers.end(), IsAir);
}

/// The islands of `area` that lie under `layer`, of which no edge meets `area`; or with `covered`
/// false the others.
MultiPolygon IslandsUnder(const MultiPolygon& area, const MultiPolygon& layer, bool covered) {
  MultiPolygon islands;
  for (const PolygonWithHoles& island : area)
    if (Covers(layer, island.outer[0]) == covered) islands.push_back(island);
  return islands;
}

/// Takes from a fill area what its skins need.
class SparseRegion {
 public:
  /// `fill_area` must outlive this.
  SparseRegion(const MultiPolygon& fill_area, Coord width_nm)
      : fill_area_(fill_area),
        fill_mask_(fill_area),
        region_(fill_area),
        mask_(fill_mask_),
        width_nm_(width_nm) {}

  /// Takes the parts over (or under) which `layer` is missing, if they are at least `least_nm`
  /// wide, and an anchor around them.
  void TakeBareParts(const MultiPolygon& layer, Coord least_nm) {
    if (!mask_.MayMeet(layer)) {
      MultiPolygon covered = IslandsUnder(region_, layer, true);
      if (covered.size() != region_.size()) Set(std::move(covered));
      return;
    }
    TakeWide(Difference(region_, layer), least_nm);
  }

  /// The same over the nearest layer below, whatever others took: where a recess widens from layer
  /// to layer, farther ones have taken all that is bare, and bridges need their anchors around that.
  void TakeUnborneParts(const MultiPolygon& layer, Coord least_nm) {
    if (!fill_mask_.MayMeet(layer)) return TakeBareParts(layer, least_nm);
    TakeWide(Difference(fill_area_, layer), least_nm);
  }

  /// The same, of what `nearer` covers.
  void TakeExposedParts(const MultiPolygon& layer, const MultiPolygon& nearer) {
    TakeWide(Difference(Intersection(region_, nearer), layer), width_nm_);
  }

  const MultiPolygon& region() const { return region_; }

 private:
  void TakeWide(MultiPolygon bare, Coord least_nm) {
    EraseSpecks(bare, width_nm_);
    const MultiPolygon core = SmoothOffset(bare, -least_nm / 2);
    if (core.empty()) return;
    Set(Difference(region_, SmoothOffset(core, least_nm / 2 + kAnchorBeads * width_nm_)));
  }

  void Set(MultiPolygon region) {
    region_ = std::move(region);
    mask_ = RegionMask(region_);
  }

  const MultiPolygon& fill_area_;
  const RegionMask fill_mask_;
  MultiPolygon region_;
  RegionMask mask_;
  Coord width_nm_;
};

/// The part of `area` that `layer` leaves bare.
MultiPolygon Exposed(const MultiPolygon& area, const MultiPolygon* layer,
                     const MultiPolygon& outline, Coord width_nm) {
  if (area.empty() || layer == &outline) return {};
  if (IsAir(layer)) return area;
  if (!RegionMask(area).MayMeet(*layer)) return IslandsUnder(area, *layer, false);
  return WithoutSlivers(Difference(area, *layer), width_nm);
}

/// Sparse infill in a narrower place between solid parts, in widths, is bits of lines: it becomes
/// solid.
constexpr Coord kLeastSparseWidths = 4;

/// How wide bare parts must be for ShellThickness::kPartial, in beads.
constexpr Coord kPartialBeads = 3;

/// Narrower parts than this share of a bead are not bare. What is bare beside walls, or in a place
/// between walls that is no wider than a bead, goes on under them: it is wider than it looks.
constexpr double kLeastBareBeads = 0.3;

Coord LeastBare(const SkinOptions& options) {
  return std::llround(kLeastBareBeads * static_cast<double>(options.width_nm));
}

/// What no layer of the cover exposes.
MultiPolygon UnexposedPart(const MultiPolygon& fill_area, const MultiPolygon& outline,
                           const Cover& cover, const SkinOptions& options) {
  static const MultiPolygon kAir;
  SparseRegion sparse(fill_area, options.width_nm);
  for (const auto* side : {&cover.above, &cover.below}) {
    const MultiPolygon* nearer = &outline;
    for (const MultiPolygon* layer : *side) {
      if (IsAir(nearer)) break;
      if (layer != nearer) sparse.TakeExposedParts(IsAir(layer) ? kAir : *layer, *nearer);
      nearer = layer;
    }
  }
  return sparse.region();
}

/// What no layer of the cover leaves bare. From far to near: what a far layer leaves bare is most
/// often all that nearer ones do.
MultiPolygon CoveredPart(const MultiPolygon& fill_area, const MultiPolygon& outline,
                         const Cover& cover, const SkinOptions& options) {
  if (options.all_solid) return {};
  if (options.shells == ShellThickness::kDisabled)
    return UnexposedPart(fill_area, outline, cover, options);
  if (HasAir(cover.above) || HasAir(cover.below)) return {};
  SparseRegion sparse(fill_area, options.width_nm);
  const bool partial = options.shells == ShellThickness::kPartial;
  for (const auto* side : {&cover.above, &cover.below}) {
    const size_t nearest = side == &cover.below ? 1 : 0;
    for (size_t i = side->size(); i-- > nearest && !sparse.region().empty();) {
      const MultiPolygon* layer = (*side)[i];
      const bool seen = i + 1 < side->size() && layer == (*side)[i + 1];
      // What lies open itself is a skin, however narrow.
      const Coord least_nm =
          partial && i > 0 ? kPartialBeads * options.width_nm : LeastBare(options);
      if (!seen && layer != &outline) sparse.TakeBareParts(*layer, least_nm);
    }
  }
  if (!cover.below.empty() && cover.below[0] != &outline)
    sparse.TakeUnborneParts(*cover.below[0], LeastBare(options));
  return sparse.region();
}

/// The narrow places of `covered` beside what is `bare`. By widths alone: whatever noise the
/// operands have, the result moves no more than they do. What lies in a right angle belongs to the
/// wide place that ends there: to its corner a disc's middle has sqrt(2) of the disc's radius.
MultiPolygon NarrowBeside(const MultiPolygon& covered, const MultiPolygon& bare, Coord width_nm) {
  const Coord least_nm = kLeastSparseWidths * width_nm;
  const MultiPolygon core = SmoothOffset(covered, -least_nm / 2);
  const Coord to_corner_nm = least_nm / 2 * 3 / 2;
  MultiPolygon narrow =
      core.empty() ? covered : Difference(covered, RoundOffset(core, to_corner_nm));
  EraseSpecks(narrow, width_nm);
  if (narrow.empty()) return {};
  // Hairs that rounding leaves along the fill area's edge are nothing bare.
  const MultiPolygon without_hairs = SmoothOffset(bare, -2 * kNoiseNm);
  narrow = Intersection(narrow, SmoothOffset(without_hairs, least_nm + 2 * kNoiseNm));
  EraseSpecks(narrow, width_nm);
  return narrow;
}

/// Parts a fill area into sparse and solid. What is narrow of the covered part becomes solid as far
/// as it lies beside something bare, as between two skins; farther off it stays sparse: a wedge
/// between walls is no skin.
void PartSparse(const MultiPolygon& fill_area, MultiPolygon covered, Coord width_nm, Skins& skins) {
  if (covered.empty() || covered == fill_area) {
    (covered.empty() ? skins.solid : skins.sparse) = fill_area;
    return;
  }
  skins.solid = Difference(fill_area, covered);
  skins.sparse = std::move(covered);
  const MultiPolygon narrow = NarrowBeside(skins.sparse, skins.solid, width_nm);
  if (narrow.empty()) return;
  skins.sparse = Difference(skins.sparse, narrow);
  skins.solid = Difference(fill_area, skins.sparse);
}

/// Takes a part from the solid region, with as much around it as the lines of bridges need to lie
/// on something at both ends, and what that leaves too narrow for a bead beside it.
MultiPolygon TakeAnchored(const MultiPolygon& part, Coord width_nm, MultiPolygon& solid) {
  if (part.empty()) return {};
  const MultiPolygon beyond = Difference(solid, SmoothOffset(part, kAnchorBeads * width_nm));
  const MultiPolygon reach = SmoothOffset(part, (kAnchorBeads + 1) * width_nm);
  MultiPolygon taken = Difference(Intersection(solid, reach), WithoutSlivers(beyond, width_nm));
  solid = Difference(solid, taken);
  return taken;
}

MultiPolygon Take(MultiPolygon part, MultiPolygon& solid) {
  if (!part.empty()) solid = Difference(solid, part);
  return part;
}

const std::vector<const MultiPolygon*>& BearersOf(const Cover& cover) {
  return cover.bearers.empty() ? cover.below : cover.bearers;
}

/// What is seen from above, but for membranes: what lies over air too has to be a bridge, or it
/// sags.
MultiPolygon TopOf(const MultiPolygon& solid, const MultiPolygon& outline, const Cover& cover,
                   Coord width_nm) {
  MultiPolygon top = Exposed(solid, cover.above[0], outline, width_nm);
  if (top.empty() || cover.on_bed || cover.below.empty()) return top;
  const MultiPolygon membranes = WithoutSlivers(
      Intersection(top, Exposed(solid, BearersOf(cover)[0], outline, width_nm)), width_nm);
  if (membranes.empty()) return top;
  return WithoutSlivers(Difference(top, SmoothOffset(membranes, kAnchorBeads * width_nm)),
                        width_nm);
}

/// Parts the solid region by what lies below it.
void PartByBearers(const MultiPolygon& outline, const Cover& cover, const SkinOptions& options,
                   Skins& skins) {
  const auto& bearers = BearersOf(cover);
  const auto bare = [&](const MultiPolygon* layer) {
    return Exposed(skins.solid, layer, outline, options.width_nm);
  };
  if (!cover.below.empty()) {
    skins.bridge = TakeAnchored(bare(bearers[0]), options.width_nm, skins.solid);
    if (cover.below[0] != bearers[0]) skins.bottom = Take(bare(cover.below[0]), skins.solid);
  }
  if (options.over_bridges && bearers.size() > 1)
    skins.over_bridge = TakeAnchored(bare(bearers[1]), options.width_nm, skins.solid);
}

}  // namespace

Skins PartFillArea(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                   const SkinOptions& options) {
  Skins skins;
  if (fill_area.empty()) return skins;
  PartSparse(fill_area, CoveredPart(fill_area, outline, cover, options), options.width_nm, skins);
  const double least_area = options.solid_below_area_mm2 * kNmPerMm * kNmPerMm;
  const size_t small =
      std::erase_if(skins.sparse, [&](const auto& region) { return Area(region) < least_area; });
  if (skins.sparse == fill_area) return skins;
  if (small > 0)
    skins.solid = skins.sparse.empty() ? fill_area : Difference(fill_area, skins.sparse);
  if (!cover.above.empty())
    skins.top = Take(TopOf(skins.solid, outline, cover, options.width_nm), skins.solid);
  if (!cover.on_bed) PartByBearers(outline, cover, options, skins);
  return skins;
}

}  // namespace slicefarm::infill
