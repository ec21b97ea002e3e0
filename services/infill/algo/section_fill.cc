#include "services/infill/algo/section_fill.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "common/model/options/fill_angles.h"
#include "services/infill/algo/axis/middle_lines.h"
#include "services/infill/algo/bridge_fill.h"
#include "services/infill/algo/fields/mean_density.h"
#include "services/infill/algo/infill_check.h"
#include "services/infill/algo/ironing.h"
#include "services/infill/algo/lines/line_flow.h"
#include "services/infill/algo/locked_zag.h"
#include "services/infill/algo/quality/fill_plastic.h"
#include "services/infill/algo/quality/line_bead.h"
#include "services/infill/algo/region_context.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/narrow_parts.h"
#include "services/infill/algo/skins/skins.h"
#include "services/infill/algo/skins/sparse_bridges.h"
#include "services/infill/algo/solid.h"
#include "services/infill/algo/sparse.h"
#include "services/infill/algo/sparse_bridging.h"

namespace slicefarm::infill {
namespace {

/// Length in nm below which lines of solid infill are so short that the head vibrates. OrcaSlicer's
/// limit.
constexpr Coord kShortSolidNm = 4'000'000;

/// Returns the plan of a region's sparse infill, or null if there is none.
const PlannedInfill* PlanOf(std::span<const PlannedInfill> plans, int32_t stack, int32_t row) {
  const auto place = [](const PlannedInfill& plan) { return std::pair(plan.stack, plan.settings); };
  const auto found = std::ranges::lower_bound(plans, std::pair(stack, row), {}, place);
  return found == plans.end() || place(*found) != std::pair(stack, row) ? nullptr : &*found;
}

const MultiPolygon& AboveSupportsOf(int32_t stack, const LayerPlan& plan) {
  static const MultiPolygon kNothing;
  const SectionPlan* found = FindPlan(stack, plan.sections);
  return found == nullptr ? kNothing : found->above_supports;
}

/// Fill of the areas of one region's settings in a section.
class RegionFill {
 public:
  /// Prepares the fill for the row `settings`. `view`, `options` and `plan` must outlive this
  /// object. `plan` may be null.
  RegionFill(const SectionView& view, int32_t settings, const InfillOptions& options,
             const PlannedInfill* plan)
      : context_(view, settings, options),
        view_(view),
        options_(options),
        cover_(context_.cover),
        row_(context_.row),
        plan_(plan),
        bodies_(view, plan),
        flows_(FlowsOf(options)),
        bridging_(context_, plan) {}

  /// Fills one area of the region. `bare`: true if no wall surrounds the area. `field`: values of
  /// the region's fields in the layer; null: no fields.
  absl::Status Fill(const FillArea& fill_area, bool bare, const LayerField* field, Fills& fills) {
    static const MultiPolygon kNone;
    const MultiPolygon* outline = view_.OutlineAt(view_.layer, row_);
    Skins skins = PartFillArea(fill_area.area, outline != nullptr ? *outline : kNone,
                               context_.near_cover.Near(Bounds(fill_area.area)),
                               {.width_nm = context_.Width(options_.solid_width_nm),
                                .solid_below_area_mm2 = options_.solid_below_area_mm2,
                                .all_solid = PlainDensity(field) >= 1 || IsSolidLayer(field),
                                .shells = options_.shells,
                                .over_bridges = options_.over_bridges || DoublesBridges()});
    middle_ = bodies_.Of(fill_area.area);
    absl::Status status;
    SparseBridges doubled, over_sparse;
    if (fill_area.role == Role::kPart && BridgesSparse(options_)) {
      const BridgedArea bridged{fill_area.area, IsFilled(field), SparseMiddle()};
      auto second = bridging_.TakeSecond(bridged, skins);
      auto bridges = bridging_.Take(bridged, skins);
      status.Update(second.status());
      status.Update(bridges.status());
      if (!status.ok()) return status;
      doubled = *std::move(second);
      over_sparse = *std::move(bridges);
    }
    status = AppendSolid(skins.top, TopLook(), fills);
    if (status.ok()) status = AppendBridges(context_, skins.bridge, fills);
    if (status.ok()) status = AppendSparseBridges(context_, over_sparse, fills);
    if (status.ok()) status = AppendSecondSparseBridges(context_, doubled, fills);
    if (status.ok()) status = AppendSolid(skins.bottom, BottomLook(), fills);
    if (status.ok()) status = AppendOverBridges(skins.over_bridge, fills);
    if (status.ok()) status = AppendInner(skins.solid, fills);
    if (status.ok()) status = AppendSparse(skins.sparse, field, fills);
    if (status.ok() && bare && fill_area.role == Role::kSupport && fills.groups.empty())
      AppendMiddle(skins.sparse, PlainDensity(field), fills);
    if (status.ok() && options_.ironing.enabled) status = AppendIroning(skins, fills);
    return status;
  }

 private:
  /// Returns the density of the whole layer, or 0 if the density varies within the layer.
  double PlainDensity(const LayerField* field) const {
    if (field == nullptr || field->density == nullptr) return options_.density;
    return field->density->UniformAt(field->z_mm).value_or(0);
  }

  /// Returns true if the region has infill somewhere in the layer.
  bool IsFilled(const LayerField* field) const {
    return PlainDensity(field) > 0 ||
           (field != nullptr && field->density != nullptr && field->density->Greatest() > 0);
  }

  bool IsSolidLayer(const LayerField* field) const {
    return IsFilled(field) && IsAllSolid(options_, view_.layer);
  }

  /// Form of the lines of a kind of solid areas.
  struct SolidLook {
    Feature feature = Feature::kSolidInfill;
    FillPattern pattern = FillPattern::kMonotonic;
    Coord width_nm = 0;
    double flow = 1;
    Coord overlap_nm = 0;
    double density = 1;
    double angle_rad = -1;  ///< direction in all layers; below 0: SolidAngle
    FillOrder order = FillOrder::kNearest;
    bool separable = false;  ///< true for infill to which separated_infills applies
  };

  Coord SurfaceOverlap() const {
    return options_.surface_overlap_nm >= 0 ? options_.surface_overlap_nm : options_.overlap_nm;
  }

  SolidLook TopLook() const {
    return {Feature::kTopSolidInfill,
            options_.top_pattern,
            options_.top_width_nm,
            options_.top_flow,
            SurfaceOverlap(),
            options_.solid.top_density,
            options_.surfaces.top_angle_rad,
            options_.surfaces.top_order};
  }

  SolidLook BottomLook() const {
    return {Feature::kSolidInfill,
            options_.bottom_pattern,
            options_.solid_width_nm,
            options_.bottom_flow,
            SurfaceOverlap(),
            options_.solid.bottom_density,
            options_.surfaces.bottom_angle_rad,
            options_.surfaces.bottom_order};
  }

  SolidLook InnerLook() const {
    return {.pattern = options_.solid_pattern,
            .width_nm = options_.solid_width_nm,
            .overlap_nm = options_.overlap_nm,
            .density = SolidDensity(options_, view_.layer),
            .separable = options_.shape.separated};
  }

  /// Returns true if the layer above a bridge over air is a bridge too.
  bool DoublesBridges() const { return DoublesExternal(options_.bridges.extra); }

  /// Adds solid infill inside the object, or the object's bottom.
  absl::Status AppendInner(const MultiPolygon& solid, Fills& fills) const {
    if (cover_.on_bed) return AppendSolid(solid, BottomLook(), fills);
    SolidLook look = InnerLook();
    if (!options_.solid.narrow_loops) return AppendSolid(solid, look, fills);
    const auto parts = PartsOf(solid, look);
    if (!parts.ok()) return parts.status();
    absl::Status status = AppendSolid(parts->wide, look, fills);
    look.pattern = FillPattern::kConcentric;
    if (status.ok()) status = AppendSolid(parts->narrow, look, fills);
    return status;
  }

  /// Divides solid infill into parts with lines and narrow parts. A corner of a wide part has short
  /// lines but is not narrow, because loops would leave gaps there. Patterns without straight lines
  /// have no short lines; with them, parts of less than two lines are narrow.
  absl::StatusOr<SolidParts> PartsOf(const MultiPolygon& solid, const SolidLook& look) const {
    const Coord spacing = Spacing(context_.Width(look.width_nm), view_.height_nm);
    if (InfoOf(look.pattern).solid != SolidFillStyle::kLines)
      return PartByWidth(solid, 2 * spacing, spacing);
    SolidParts parts = PartByWidth(solid, kShortSolidNm, spacing);
    if (parts.narrow.empty()) return parts;
    auto by_lines = PartByLines(
        parts.narrow,
        {.angle_rad = context_.SolidAngle(look.pattern), .pitch_nm = static_cast<double>(spacing)},
        static_cast<double>(kShortSolidNm));
    if (!by_lines.ok()) return by_lines.status();
    parts.narrow = std::move(by_lines->narrow);
    parts.wide = parts.narrow.empty() ? solid : Difference(solid, parts.narrow);
    return parts;
  }

  /// Adds the areas over bridges of the layer below: second bridges, or solid infill with its own
  /// feature.
  absl::Status AppendOverBridges(const MultiPolygon& regions, Fills& fills) {
    if (regions.empty()) return absl::OkStatus();
    if (DoublesBridges()) {
      if (!bridges_below_) bridges_below_.emplace(SpannedBridges::Below(context_));
      return AppendSecondBridges(context_, regions, *bridges_below_, fills);
    }
    SolidLook look = InnerLook();
    look.feature = Feature::kSolidOverBridge;
    return AppendSolid(regions, look, fills);
  }

  absl::Status AppendSolid(const MultiPolygon& regions, const SolidLook& look, Fills& fills) const {
    if (look.density <= 0) return absl::OkStatus();
    const LineBead bead =
        SparseBead(context_.Width(look.width_nm), view_.height_nm, look.flow, look.density);
    SolidFill fill = context_.FillOf(
        look.feature, look.pattern,
        look.angle_rad < 0 ? context_.SolidAngle(look.pattern) : look.angle_rad + options_.turn_rad,
        bead.width_nm, look.overlap_nm);
    fill.order = look.order;
    if (fill.center && (options_.surfaces.center == SurfaceCenter::kBody || look.separable))
      fill.center = middle_;
    for (const PolygonWithHoles& region : regions) {
      auto group = FillSolid(region, fill);
      if (!group.ok()) return group.status();
      if (!flows_.empty())
        for (Path& path : group->paths) ThinShortLines(flows_, view_.height_nm, path);
      ScaleSections(bead.share, view_.height_nm, view_.height_nm, group->paths);
      context_.Append(*std::move(group),
                      {look.feature, look.pattern, Area(region), view_.height_nm, bead.share},
                      fills);
    }
    return absl::OkStatus();
  }

  /// Adds the walls around `ironed`: walls that are also visible from above, or all walls if the
  /// whole layer is solid. Then grows the area by the expansion of the settings. The result ends
  /// half a nozzle, or the inset of the settings, before the part's outline, so that no plastic is
  /// pushed over the outline.
  MultiPolygon WithWallsIroned(MultiPolygon ironed, bool all) const {
    const MultiPolygon* whole = view_.OutlineAt(view_.layer);
    const MultiPolygon* own = view_.OutlineAt(view_.layer, context_.settings);
    if (whole == nullptr || own == nullptr) return ironed;
    if (options_.walls_nm > 0) {
      MultiPolygon walls = Intersection(FastOffset(ironed, options_.walls_nm), *own);
      const MultiPolygon* above = all ? nullptr : view_.OutlineAt(view_.layer + 1, row_);
      if (above != nullptr) walls = Difference(walls, *above);
      ironed = Union(ironed, walls);
    }
    if (options_.ironing.expansion_nm != 0)
      ironed = FastOffset(ironed, options_.ironing.expansion_nm);
    const Coord inset =
        options_.ironing.inset_nm > 0 ? options_.ironing.inset_nm : options_.nozzle_nm / 2;
    return Intersection(ironed, FastOffset(*whole, -inset));
  }

  /// Adds ironing of the areas that the next layer does not cover. If only the topmost layer is to
  /// be ironed, other layers have none.
  absl::Status AppendIroning(const Skins& skins, Fills& fills) const {
    const IroningType type = options_.ironing.type;
    if (type == IroningType::kTopmost && view_.OutlineAt(view_.layer + 1) != nullptr)
      return absl::OkStatus();
    MultiPolygon ironed = skins.top;
    if (type == IroningType::kSolid)
      for (const MultiPolygon* solid : {&skins.bottom, &skins.over_bridge, &skins.solid})
        if (!solid->empty()) ironed = Union(ironed, *solid);
    if (ironed.empty()) return absl::OkStatus();
    const bool all = type == IroningType::kSolid && skins.sparse.empty() && skins.bridge.empty();
    ironed = WithWallsIroned(std::move(ironed), all);
    auto group = IronedLines(ironed, {.angle_rad = context_.SolidAngle(options_.top_pattern),
                                      .width_nm = context_.Width(options_.top_width_nm),
                                      .height_nm = view_.height_nm,
                                      .ironing = options_.ironing});
    if (!group.ok()) return group.status();
    context_.Append(
        *std::move(group),
        {Feature::kIroning,
         options_.ironing.concentric ? FillPattern::kConcentric : FillPattern::kMonotonic,
         Area(ironed), view_.height_nm, options_.ironing.flow},
        fills);
    return absl::OkStatus();
  }

  /// Adds the sparse infill of a region. A field with only one density for the whole layer is not
  /// passed to the pattern.
  absl::Status AppendSparse(const MultiPolygon& region, const LayerField* field,
                            Fills& fills) const {
    const bool plain =
        field == nullptr || (field->directions == nullptr && IsPlain(*field->density, *field));
    const FillPattern pattern = plan_ == nullptr ? options_.pattern : plan_->pattern;
    SparseFill fill{.pattern = pattern,
                    .density = PlainDensity(field),
                    .angle_rad = context_.angles.sparse_rad,
                    .layer = PatternLayer(pattern, context_.angles, view_.layer),
                    .z_nm = view_.z_nm,
                    .width_nm = context_.Width(options_.sparse_width_nm),
                    .height_nm = view_.height_nm,
                    .overlap_nm = options_.overlap_nm,
                    .anchor_nm = options_.anchor_nm,
                    .anchor_max_nm = options_.anchor_max_nm,
                    .smoothing_nm = options_.smoothing_nm,
                    .shape = options_.shape,
                    .field = plain ? nullptr : field};
    if (plan_ == nullptr) return AppendSparsePart(region, fill, fills);
    fill.planned = plan_->lines;
    const MultiPolygon filled =
        plan_->left_out.empty() ? region : Difference(region, plan_->left_out);
    if (plan_->combined.empty()) return AppendSparsePart(filled, fill, fills);
    const absl::Status status = AppendSparsePart(Difference(filled, plan_->combined), fill, fills);
    if (!status.ok()) return status;
    fill.height_nm = plan_->combined_height_nm;
    return AppendSparsePart(Intersection(filled, plan_->combined), fill, fills);
  }

  /// Adds a line along the middle of a column of supports that the pattern's lines miss. Otherwise
  /// the structure on the column would be printed into the air.
  void AppendMiddle(const MultiPolygon& column, double density, Fills& fills) const {
    const Coord width_nm = context_.Width(options_.sparse_width_nm);
    const double least_nm = kMinLoneWidths * static_cast<double>(width_nm);
    context_.Append({false, MiddleLines(column, width_nm, least_nm)},
                    {Feature::kInternalInfill, std::nullopt, 0, view_.height_nm, density}, fills);
  }

  /// Adds a part of the sparse infill. Beads of another height than the layer's get the width that
  /// their plastic would have in the layer.
  absl::Status AppendSparsePart(const MultiPolygon& region, const SparseFill& fill,
                                Fills& fills) const {
    if (region.empty() || (fill.field == nullptr && fill.density <= 0)) return absl::OkStatus();
    if (fill.pattern == FillPattern::kLockedZag && fill.field == nullptr)
      return AppendZones(region, fill, fills);
    const Point middle = fill.field == nullptr ? SparseMiddle() : Point{};
    auto paths = FillSparse(middle == Point{} ? region : Moved(region, Point{} - middle), fill);
    if (!paths.ok()) return paths.status();
    for (Path& path : *paths)
      for (Point& p : path.points) p = p + middle;
    if (fill.height_nm != view_.height_nm)
      ScaleSections(1, fill.height_nm, view_.height_nm, *paths);
    RequestedFill asked{Feature::kInternalInfill, fill.pattern, Area(region), fill.height_nm,
                        fill.density};
    if (fill.field != nullptr) {
      const auto share = MeanDensity(region, *fill.field);
      if (!share.ok()) return share.status();
      asked.share = *share;
      if (fill.field->directions != nullptr) asked.pattern = std::nullopt;
    }
    context_.Append({false, *std::move(paths)}, asked, fills);
    return absl::OkStatus();
  }

  /// Adds skin and skeleton of the pattern lockedzag.
  absl::Status AppendZones(const MultiPolygon& region, const SparseFill& fill, Fills& fills) const {
    absl::Status status;
    for (SparseZone& zone : LockedZones(region, fill, options_.zones)) {
      zone.fill.width_nm = context_.Width(zone.fill.width_nm);
      status.Update(AppendSparsePart(zone.area, zone.fill, fills));
    }
    return status;
  }

  /// Returns the point around which the pattern of the sparse infill is laid out. Lines that
  /// planning laid out stay where they are.
  Point SparseMiddle() const {
    const FillPattern pattern = plan_ == nullptr ? options_.pattern : plan_->pattern;
    return options_.shape.separated && !InfoOf(pattern).planned ? middle_ : Point{};
  }

  static bool IsPlain(const DensityField& density, const LayerField& field) {
    return density.dither == Dither::kNone && density.UniformAt(field.z_mm).has_value();
  }

  const RegionContext context_;
  // Members of the context:
  const SectionView& view_;
  const InfillOptions& options_;
  const Cover& cover_;
  const std::optional<int32_t>& row_;

  const PlannedInfill* plan_;
  const BodyMiddles bodies_;
  const FlowTable flows_;
  SparseBridging bridging_;
  std::optional<SpannedBridges> bridges_below_;  ///< made when first needed
  Point middle_;  ///< middle of the body of the area that is being filled
};

/// Sets settings, tool and feature of each path and each use.
void Sign(const FillArea& area, Fills& fills) {
  for (FillGroup& group : fills.groups) {
    for (Path& path : group.paths) {
      path.settings = area.settings;
      path.tool = area.tool;
      path.feature = FeatureFor(area.role, path.feature);
    }
  }
  for (FillStats& use : fills.uses) {
    use.settings = area.settings;
    use.feature = FeatureFor(area.role, use.feature);
  }
}

}  // namespace

absl::StatusOr<FilledSection> FillSection(WalledSection walled, bool on_bed,
                                          const ObjectLayers& objects, const LayerPlan& plan,
                                          std::span<const InfillOptions> regions,
                                          RegionFields& fields) {
  SectionView view{walled.stack, walled.layer, walled.height_nm,
                   on_bed,       objects,      AboveSupportsOf(walled.stack.id, plan)};
  if (const ObjectSection* own = objects.Find(walled.stack.id, walled.layer); own != nullptr)
    view.z_nm = own->z_nm - own->height_nm / 2;
  FilledSection filled{walled.stack, walled.layer, walled.height_nm, {}};
  std::map<int32_t, RegionFill> fillers;  // indexed by row
  for (WalledIsland& island : walled.islands) {
    FilledIsland result;
    result.walls = std::move(island.walls);
    result.outline = std::move(island.outline);
    for (const FillArea& area : island.fill_areas) {
      const InfillOptions& options = regions[static_cast<size_t>(area.settings)];
      absl::Status usable = CheckWidths(view, options);
      usable.Update(CheckFlows(options));
      if (!usable.ok()) return usable;
      const auto filler = fillers
                              .try_emplace(area.settings, view, area.settings, options,
                                           PlanOf(plan.infill, view.stack.id, area.settings))
                              .first;
      const auto field = fields.Of(area.settings, walled.stack.id, walled.layer,
                                   ToMm(static_cast<double>(view.z_nm)));
      if (!field.ok()) return field.status();
      Fills fills;
      absl::Status ok = filler->second.Fill(area, result.walls.empty(),
                                            field->has_value() ? &**field : nullptr, fills);
      if (!ok.ok()) return ok;
      Sign(area, fills);
      std::ranges::move(fills.groups, std::back_inserter(result.fills));
      for (const FillStats& use : fills.uses) AddUse(use, 1, filled.uses);
    }
    filled.islands.push_back(std::move(result));
  }
  return filled;
}

}  // namespace slicefarm::infill
