#include "services/infill/algo/sparse_bridging.h"

#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/box_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/infill_options.h"
#include "services/infill/algo/section_view.h"

namespace slicefarm::infill {
namespace {

bool IsSolidLayer(const RegionContext& context, const BridgedArea& fill) {
  return fill.filled && IsAllSolid(context.options, context.view.layer);
}

}  // namespace

/// Layer below a region. Its bridges bear second bridges.
struct SparseBridging::LowerLayer {
  LowerLayer(const RegionContext& above, const PlannedInfill* plan)
      : view(above.view.Below()),
        context(view, above.settings, above.options),
        outline(view.OutlineAt(view.layer, above.row)),
        within_walls(outline == nullptr ? MultiPolygon{}
                                        : FastOffset(*outline, -above.options.walls_nm)),
        islands(within_walls),
        bridging(context, plan) {}

  const SectionView view;
  const RegionContext context;
  const MultiPolygon* const outline;  ///< null: the layer below does not have the region
  const MultiPolygon within_walls;
  const BoxIndex islands;  ///< index of `within_walls`
  SparseBridging bridging;
};

SparseBridging::SparseBridging(const RegionContext& context, const PlannedInfill* plan)
    : context_(context), plan_(plan) {}

SparseBridging::~SparseBridging() = default;

Coord SparseBridging::WidthNm() const { return context_.Width(context_.options.solid_width_nm); }

/// Returns true if this layer may have skins that the layer below does not have. The skins of the
/// layer below reach one layer less high.
bool SparseBridging::SkinsBegin(const BridgedArea& fill) const {
  if (IsSolidLayer(context_, fill)) return true;
  const auto& above = context_.cover.above;
  return above.size() < 2 || above.back() == nullptr || above.back() != above[above.size() - 2];
}

absl::StatusOr<SparseBridges> SparseBridging::Take(const BridgedArea& fill, Skins& skins) {
  if (skins.solid.empty() || !SkinsBegin(fill)) return SparseBridges{};
  const InfillOptions& options = context_.options;
  const MultiPolygon middles =
      BridgeMiddles(skins.solid, LeastBridgedGapNm(options, context_.view.height_nm), WidthNm());
  if (middles.empty()) return SparseBridges{};
  if (!under_) under_.emplace(RegionView{context_.view, options, plan_, context_.row});
  return under_->TakeBridges(fill.area, middles, WidthNm(), fill.middle, skins);
}

absl::StatusOr<SparseBridges> SparseBridging::TakeSecond(const BridgedArea& fill, Skins& skins) {
  SparseBridges second;
  const InfillOptions& options = context_.options;
  if (!DoublesInternal(options.bridges.extra) || skins.solid.empty()) return second;
  if (lower_ == nullptr) lower_ = std::make_unique<LowerLayer>(context_, plan_);
  if (lower_->outline == nullptr) return second;
  const MultiPolygon area = Intersection(
      fill.area, IslandsNear(Bounds(fill.area), lower_->within_walls, lower_->islands));
  Skins lower = PartFillArea(area, *lower_->outline, lower_->context.near_cover.Near(Bounds(area)),
                             {.width_nm = WidthNm(),
                              .solid_below_area_mm2 = options.solid_below_area_mm2,
                              .all_solid = IsSolidLayer(lower_->context, fill),
                              .shells = options.shells});
  auto first = lower_->bridging.Take({area, fill.filled, fill.middle}, lower);
  if (!first.ok()) return first.status();
  const MultiPolygon over = Intersection(skins.solid, first->regions);
  second.regions =
      Intersection(skins.solid, FastOffset(FastOffset(over, -WidthNm() / 2), WidthNm() / 2));
  second.bearers = std::move(first->bearers);
  if (!second.regions.empty()) skins.solid = Difference(skins.solid, second.regions);
  return second;
}

}  // namespace slicefarm::infill
