#include "services/infill/algo/skins/skins.h"

#include <algorithm>
#include <cmath>
#include <optional>
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

/// Width of the anchors of skins in the sparse region, and of bridges on their supports, in beads.
constexpr Coord kAnchorBeads = 2;

/// Offsets a region like SmoothOffset, but with round corners, precise to 2 % of the distance. The
/// reach of miters changes abruptly with the angle, at tips of 60 degrees.
MultiPolygon RoundOffset(const MultiPolygon& region, Coord distance_nm) {
  return Offset(Simplify(region, kNoiseNm), distance_nm,
                {.join = Join::kRound, .arc_tolerance_nm = distance_nm / 50});
}

/// Returns the part of `region` that is at least `width_nm` wide.
MultiPolygon WithoutSlivers(const MultiPolygon& region, Coord width_nm) {
  const MultiPolygon core = SmoothOffset(region, -width_nm / 2);
  if (core.empty()) return {};
  // Tips outside of the grown core are noise to SmoothOffset.
  return Intersection(region, SmoothOffset(core, width_nm / 2 + kNoiseNm / 2));
}

/// Removes islands that are smaller than a dot of a bead.
void EraseSpecks(MultiPolygon& region, Coord width_nm) {
  const double least = static_cast<double>(width_nm) * static_cast<double>(width_nm);
  std::erase_if(region, [least](const PolygonWithHoles& island) { return Area(island) < least; });
}

bool IsAir(const MultiPolygon* layer) { return layer == nullptr || layer->empty(); }

bool HasAir(const std::vector<const MultiPolygon*>& layers) {
  return std::any_of(layers.begin(), layers.end(), IsAir);
}

/// Returns the islands of `area` that are under `layer`, or with `covered` false all other islands.
/// REQUIRES: no edge of `layer` meets `area`.
MultiPolygon IslandsUnder(const MultiPolygon& area, const MultiPolygon& layer, bool covered) {
  MultiPolygon islands;
  for (const PolygonWithHoles& island : area)
    if (Covers(layer, island.outer[0]) == covered) islands.push_back(island);
  return islands;
}

/// Part of a fill area that all layers around it cover.
struct CoveredPart {
  MultiPolygon region;
  /// Areas that were removed from the fill area and left the region. Their edges cross the edges of
  /// the fill area, so that operations with both are fast. Nullopt: whole islands were removed.
  std::optional<MultiPolygon> taken = {};
};

/// Part of a fill area that remains after its skins are removed.
class SparseRegion {
 public:
  /// Begins with the whole area. `fill_area` must outlive this object.
  SparseRegion(const MultiPolygon& fill_area, Coord width_nm)
      : fill_area_(fill_area),
        fill_mask_(fill_area),
        region_(fill_area),
        mask_(fill_mask_),
        width_nm_(width_nm) {}

  /// Removes the parts that `layer` does not cover, if they are at least `least_nm` wide, together
  /// with an anchor around them. Returns true if parts were removed.
  bool TakeBareParts(const MultiPolygon& layer, Coord least_nm) {
    if (mask_.MayMeet(layer)) return TakeWide(Difference(region_, layer), least_nm);
    MultiPolygon covered = IslandsUnder(region_, layer, true);
    if (covered.size() == region_.size()) return false;
    taken_.reset();
    Set(std::move(covered));
    return true;
  }

  /// Removes the parts that `layer`, the nearest layer below, does not support, computed from the
  /// whole fill area. If a recess widens from layer to layer, farther layers have already removed
  /// all parts that are not covered. But bridges still need their anchors around these parts.
  void TakeUnborneParts(const MultiPolygon& layer, Coord least_nm) {
    if (fill_mask_.MayMeet(layer))
      TakeWide(Difference(fill_area_, layer), least_nm);
    else
      TakeBareParts(layer, least_nm);
  }

  /// Removes the parts that `nearer` covers and `layer` does not.
  void TakeExposedParts(const MultiPolygon& layer, const MultiPolygon& nearer) {
    TakeWide(Difference(Intersection(region_, nearer), layer), width_nm_);
  }

  const MultiPolygon& region() const { return region_; }

  /// Returns the remaining region. This object must not be used afterwards.
  CoveredPart Result() { return {std::move(region_), std::move(taken_)}; }

 private:
  bool TakeWide(MultiPolygon bare, Coord least_nm) {
    EraseSpecks(bare, width_nm_);
    const MultiPolygon core = SmoothOffset(bare, -least_nm / 2);
    if (core.empty()) return false;
    const MultiPolygon wide = SmoothOffset(core, least_nm / 2 + kAnchorBeads * width_nm_);
    Set(Difference(region_, wide));
    if (taken_) taken_ = Union(*taken_, wide);
    return true;
  }

  void Set(MultiPolygon region) {
    region_ = std::move(region);
    mask_ = RegionMask(region_);
  }

  const MultiPolygon& fill_area_;
  const RegionMask fill_mask_;
  MultiPolygon region_;
  RegionMask mask_;
  std::optional<MultiPolygon> taken_ = MultiPolygon{};  ///< see CoveredPart::taken
  Coord width_nm_;
};

/// Returns the part of `area` that `layer` does not cover.
MultiPolygon Exposed(const MultiPolygon& area, const MultiPolygon* layer,
                     const MultiPolygon& outline, Coord width_nm) {
  if (area.empty() || layer == &outline) return {};
  if (IsAir(layer)) return area;
  if (!RegionMask(area).MayMeet(*layer)) return IslandsUnder(area, *layer, false);
  return WithoutSlivers(Difference(area, *layer), width_nm);
}

/// Smallest width of sparse infill between solid parts, in widths. A narrower part would have only
/// short bits of lines, so that it becomes solid.
constexpr Coord kLeastSparseWidths = 4;

/// Smallest width of parts that are not covered, for ShellThickness::kPartial, in beads.
constexpr Coord kPartialBeads = 3;

/// Smallest width of parts that are not covered, as a share of a bead. Such a part beside walls, or
/// between walls no more than a bead apart, continues under the walls: it is wider than it seems.
constexpr double kLeastBareBeads = 0.3;

Coord LeastBare(const SkinOptions& options) {
  return std::llround(kLeastBareBeads * static_cast<double>(options.width_nm));
}

/// Returns the sparse part with disabled shells: each part of a skin must be covered by the next
/// nearer layer.
CoveredPart UnexposedPart(const MultiPolygon& fill_area, const MultiPolygon& outline,
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
  return sparse.Result();
}

/// Returns true if the regions have a point in common. `wanted` may be null: the whole plane.
bool Meets(const MultiPolygon& region, const MultiPolygon* wanted) {
  return wanted == nullptr ? !region.empty() : !Intersection(*wanted, region).empty();
}

/// Returns the part of the fill area that all layers of `cover` cover. The farthest layer of each
/// side is tested first, because it usually leaves the most uncovered. Returns an empty area as
/// soon as the remaining part does not meet `wanted` (null: no such test).
CoveredPart FindCovered(const MultiPolygon& fill_area, const MultiPolygon& outline,
                        const Cover& cover, const SkinOptions& options,
                        const MultiPolygon* wanted = nullptr) {
  if (options.all_solid) return {};
  if (options.shells == ShellThickness::kDisabled)
    return UnexposedPart(fill_area, outline, cover, options);
  if (HasAir(cover.above) || HasAir(cover.below)) return {};
  SparseRegion sparse(fill_area, options.width_nm);
  const bool partial = options.shells == ShellThickness::kPartial;
  for (const auto* side : {&cover.above, &cover.below}) {
    const size_t nearest = side == &cover.below ? 1 : 0;
    for (size_t i = side->size(); i-- > nearest;) {
      const MultiPolygon* layer = (*side)[i];
      const bool seen = i + 1 < side->size() && layer == (*side)[i + 1];
      // A part that the nearest layer does not cover is a skin, however narrow it is.
      const Coord least_nm =
          partial && i > 0 ? kPartialBeads * options.width_nm : LeastBare(options);
      if (seen || layer == &outline) continue;
      if (sparse.TakeBareParts(*layer, least_nm) && !Meets(sparse.region(), wanted)) return {};
    }
  }
  if (!cover.below.empty() && cover.below[0] != &outline)
    sparse.TakeUnborneParts(*cover.below[0], LeastBare(options));
  return sparse.Result();
}

/// Cosine of 92 degrees. At a corner that turns by less, a disc around the inset's corner with 1.44
/// times the inset's distance as its radius reaches the outline's corner.
constexpr double kLeastBluntCosine = -0.035;

bool IsBlunt(const Polygon& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point at = ring[i];
    const Point in = at - ring[i == 0 ? ring.size() - 1 : i - 1];
    const Point out = ring[i + 1 == ring.size() ? 0 : i + 1] - at;
    if (Cross(in, out) > 0 && Dot(in, out) < kLeastBluntCosine * Norm(in) * Norm(out)) return false;
  }
  return true;
}

/// Returns true if discs of 1.5 radii around the region's inset by a radius certainly cover the
/// region: each edge of the inset is one of the region's, and no corner is sharp.
bool IsWide(const MultiPolygon& region, Coord radius_nm) {
  return std::all_of(region.begin(), region.end(), [&](const PolygonWithHoles& island) {
    const auto inset = TryOffset({island}, -radius_nm);
    if (!inset) return false;
    const PolygonWithHoles& core = inset->polygons.front();
    return IsBlunt(core.outer) && std::all_of(core.holes.begin(), core.holes.end(), IsBlunt);
  });
}

/// Returns the narrow parts of `covered` beside `bare`. Only widths decide, so that noise in the
/// operands moves the result by no more than the noise. An area in a right angle belongs to the
/// wide area that ends there: the centre of a disc is sqrt(2) radii from the corner.
MultiPolygon NarrowBeside(const MultiPolygon& covered, const MultiPolygon& bare, Coord width_nm) {
  const Coord least_nm = kLeastSparseWidths * width_nm;
  if (IsWide(Simplify(covered, kNoiseNm), least_nm / 2)) return {};
  const MultiPolygon core = SmoothOffset(covered, -least_nm / 2);
  const Coord to_corner_nm = least_nm / 2 * 3 / 2;
  MultiPolygon narrow =
      core.empty() ? covered : Difference(covered, RoundOffset(core, to_corner_nm));
  EraseSpecks(narrow, width_nm);
  if (narrow.empty()) return {};
  // Tiny slivers from rounding along the fill area's boundary do not count as bare.
  const MultiPolygon without_hairs = SmoothOffset(bare, -2 * kNoiseNm);
  narrow = Intersection(narrow, SmoothOffset(without_hairs, least_nm + 2 * kNoiseNm));
  EraseSpecks(narrow, width_nm);
  return narrow;
}

/// Returns the part of the fill area that is not covered. A difference of the fill area and its
/// part would be slow, because the two share edges.
MultiPolygon BareOf(const MultiPolygon& fill_area, const CoveredPart& covered) {
  return covered.taken ? Intersection(fill_area, *covered.taken)
                       : Difference(fill_area, covered.region);
}

/// Divides a fill area into sparse and solid parts. `covered`: the part that all layers cover. A
/// narrow covered part beside an uncovered part, as between two skins, becomes solid. Farther away
/// from uncovered parts it stays sparse: a wedge between walls is no skin. Small sparse regions
/// become solid too. Returns false if parts that became solid are still missing in `skins.solid`.
bool PartSparse(const MultiPolygon& fill_area, CoveredPart covered, const SkinOptions& options,
                Skins& skins) {
  bool complete = true;
  if (covered.region.empty()) {
    skins.solid = fill_area;
  } else if (covered.region == fill_area) {
    skins.sparse = fill_area;
  } else {
    skins.solid = BareOf(fill_area, covered);
    skins.sparse = std::move(covered.region);
    const MultiPolygon narrow = NarrowBeside(skins.sparse, skins.solid, options.width_nm);
    complete = narrow.empty();
    if (!complete) skins.sparse = Difference(skins.sparse, narrow);
  }
  const double least_area = options.solid_below_area_mm2 * kNmPerMm * kNmPerMm;
  return std::erase_if(skins.sparse,
                       [&](const auto& region) { return Area(region) < least_area; }) == 0 &&
         complete;
}

/// Removes a part from the solid region, with a margin that supports the lines of bridges at both
/// ends. The remainder beside it that is too narrow for a bead is removed too.
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

/// Returns the parts visible from above, without membranes. A membrane is a part that is also over
/// air: it has to be a bridge, or it sags.
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

/// Divides the solid region by the layers below it.
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
  const bool complete =
      PartSparse(fill_area, FindCovered(fill_area, outline, cover, options), options, skins);
  if (skins.sparse == fill_area) return skins;
  if (!complete)
    skins.solid = skins.sparse.empty() ? fill_area : Difference(fill_area, skins.sparse);
  if (!cover.above.empty())
    skins.top = Take(TopOf(skins.solid, outline, cover, options.width_nm), skins.solid);
  if (!cover.on_bed) PartByBearers(outline, cover, options, skins);
  return skins;
}

MultiPolygon SparsePart(const MultiPolygon& fill_area, const MultiPolygon& outline,
                        const Cover& cover, const SkinOptions& options,
                        const MultiPolygon& wanted) {
  Skins skins;
  CoveredPart covered = FindCovered(fill_area, outline, cover, options, &wanted);
  if (Meets(covered.region, &wanted)) PartSparse(fill_area, std::move(covered), options, skins);
  return std::move(skins.sparse);
}

}  // namespace slicefarm::infill
