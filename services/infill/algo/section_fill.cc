#include "services/infill/algo/section_fill.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/fill_angles.h"
#include "services/infill/algo/axis/middle_lines.h"
#include "services/infill/algo/fields/mean_density.h"
#include "services/infill/algo/infill_check.h"
#include "services/infill/algo/ironing.h"
#include "services/infill/algo/lines/line_flow.h"
#include "services/infill/algo/locked_zag.h"
#include "services/infill/algo/quality/fill_plastic.h"
#include "services/infill/algo/quality/line_bead.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/bridge_angle.h"
#include "services/infill/algo/skins/narrow_parts.h"
#include "services/infill/algo/skins/overhang_fill.h"
#include "services/infill/algo/skins/skins.h"
#include "services/infill/algo/skins/sparse_bridges.h"
#include "services/infill/algo/solid.h"
#include "services/infill/algo/sparse.h"
#include "services/infill/algo/sparse_under.h"

namespace slicefarm::infill {
namespace {

/// Width in nm below which solid infill is narrow: its lines would be so short that the head
/// vibrates. OrcaSlicer's limit of a line's length.
constexpr Coord kNarrowSolidNm = 4'000'000;

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

/// Groups of paths that fill areas, and the reports of their plastic.
struct Fills {
  std::vector<FillGroup> groups;
  std::vector<FillStats> uses;
};

/// Fill of the areas of one region's settings in a section.
class RegionFill {
 public:
  /// Prepares the fill for the row `settings`. `view`, `options` and `plan` must outlive this
  /// object. `plan` may be null.
  RegionFill(const SectionView& view, int32_t settings, const InfillOptions& options,
             const PlannedInfill* plan)
      : view_(view),
        options_(options),
        plan_(plan),
        settings_(settings),
        row_(options.interface_shells ? std::optional(settings) : std::nullopt),
        cover_(CoverOf(view, options, row_)),
        angles_(AnglesOf(options, view.layer)),
        flows_(FlowsOf(options)) {}

  /// Fills one area of the region. `bare`: true if no wall surrounds the area. `field`: values of
  /// the region's fields in the layer; null: no fields.
  absl::Status Fill(const FillArea& fill_area, bool bare, const LayerField* field, Fills& fills) {
    static const MultiPolygon kNone;
    const MultiPolygon* outline = view_.OutlineAt(view_.layer, row_);
    Skins skins = PartFillArea(fill_area.area, outline != nullptr ? *outline : kNone, cover_,
                               {.width_nm = Width(options_.solid_width_nm),
                                .solid_below_area_mm2 = options_.solid_below_area_mm2,
                                .all_solid = PlainDensity(field) >= 1 || IsSolidLayer(field),
                                .shells = options_.shells,
                                .over_bridges = options_.over_bridges});
    SparseBridges over_sparse;
    if (fill_area.role == Role::kPart && BridgesSparse(options_) && !skins.solid.empty() &&
        SkinsBegin(field)) {
      auto bridges = BridgesOverSparse(fill_area.area, skins);
      if (!bridges.ok()) return bridges.status();
      over_sparse = *std::move(bridges);
    }
    const FillPattern inner = cover_.on_bed ? options_.bottom_pattern : options_.solid_pattern;
    const Coord surface_overlap_nm =
        options_.surface_overlap_nm >= 0 ? options_.surface_overlap_nm : options_.overlap_nm;
    absl::Status status = AppendSolid(skins.top, Feature::kTopSolidInfill, options_.top_pattern,
                                      options_.top_width_nm, options_.top_flow, surface_overlap_nm,
                                      fills, options_.solid.top_density);
    if (status.ok()) status = AppendBridges(skins.bridge, fills);
    if (status.ok()) status = AppendSparseBridges(over_sparse, fills);
    const auto append = [&](const MultiPolygon& regions, Feature feature, FillPattern pattern,
                            double flow, Coord overlap_nm, double density = 1) {
      if (status.ok())
        status = AppendSolid(regions, feature, pattern, options_.solid_width_nm, flow, overlap_nm,
                             fills, density);
    };
    append(skins.bottom, Feature::kSolidInfill, options_.bottom_pattern, options_.bottom_flow,
           surface_overlap_nm, options_.solid.bottom_density);
    append(skins.over_bridge, Feature::kSolidOverBridge, inner, 1, options_.overlap_nm);
    if (cover_.on_bed) {
      append(skins.solid, Feature::kSolidInfill, inner, options_.bottom_flow, surface_overlap_nm,
             options_.solid.bottom_density);
    } else if (options_.solid.narrow_loops) {
      const SolidParts parts =
          PartByWidth(skins.solid, kNarrowSolidNm, Width(options_.solid_width_nm));
      append(parts.wide, Feature::kSolidInfill, inner, 1, options_.overlap_nm);
      append(parts.narrow, Feature::kSolidInfill, FillPattern::kConcentric, 1, options_.overlap_nm);
    } else {
      append(skins.solid, Feature::kSolidInfill, inner, 1, options_.overlap_nm);
    }
    if (status.ok()) status = AppendSparse(skins.sparse, field, fills);
    if (status.ok() && bare && fill_area.role == Role::kSupport && fills.groups.empty())
      AppendMiddle(skins.sparse, PlainDensity(field), fills);
    if (status.ok() && options_.ironing.enabled) status = AppendIroning(skins, fills);
    return status;
  }

 private:
  Coord Width(Coord width_nm) const {
    return view_.on_bed ? options_.first_layer_width_nm : width_nm;
  }

  /// Returns the density of the whole layer, or 0 if the density varies within the layer.
  double PlainDensity(const LayerField* field) const {
    if (field == nullptr || field->density == nullptr) return options_.density;
    return field->density->UniformAt(field->z_mm).value_or(0);
  }

  bool IsSolidLayer(const LayerField* field) const {
    const bool filled = PlainDensity(field) > 0 || (field != nullptr && field->density != nullptr &&
                                                    field->density->Greatest() > 0);
    return filled && IsAllSolid(options_, view_.layer);
  }

  /// Returns the angle of solid lines. It turns by a right angle from layer to layer, except for
  /// patterns that do not turn and for templates, which contain all turns.
  double SolidAngle(FillPattern pattern) const {
    const bool turns = !angles_.solid_planned && !IsAligned(pattern) && view_.layer % 2 != 0;
    return angles_.solid_rad + (turns ? std::numbers::pi / 2 : 0);
  }

  void Append(FillGroup group, const RequestedFill& asked, Fills& fills) const {
    AddUse(UseOf(asked, group.paths, view_.height_nm), 1, fills.uses);
    if (!group.paths.empty()) fills.groups.push_back(std::move(group));
  }

  absl::Status AppendSolid(const MultiPolygon& regions, Feature feature, FillPattern pattern,
                           Coord width_nm, double flow, Coord overlap_nm, Fills& fills,
                           double density = 1) const {
    if (density <= 0) return absl::OkStatus();
    const LineBead bead = SparseBead(Width(width_nm), view_.height_nm, flow, density);
    for (const PolygonWithHoles& region : regions) {
      auto group =
          SolidLines(region, feature, pattern, SolidAngle(pattern), bead.width_nm, overlap_nm);
      if (!group.ok()) return group.status();
      if (!flows_.empty())
        for (Path& path : group->paths) ThinShortLines(flows_, view_.height_nm, path);
      ScaleSections(bead.share, view_.height_nm, view_.height_nm, group->paths);
      Append(*std::move(group), {feature, pattern, Area(region), view_.height_nm, bead.share},
             fills);
    }
    return absl::OkStatus();
  }

  /// Adds the walls around `ironed`: walls that are also visible from above, or all walls if the
  /// whole layer is solid. The result ends half a nozzle, or the inset of the settings, before the
  /// part's outline, so that no plastic is pushed over the outline.
  MultiPolygon WithWallsIroned(MultiPolygon ironed, bool all) const {
    const MultiPolygon* whole = view_.OutlineAt(view_.layer);
    const MultiPolygon* own = view_.OutlineAt(view_.layer, settings_);
    if (whole == nullptr || own == nullptr) return ironed;
    if (options_.walls_nm > 0) {
      MultiPolygon walls = Intersection(FastOffset(ironed, options_.walls_nm), *own);
      const MultiPolygon* above = all ? nullptr : view_.OutlineAt(view_.layer + 1, row_);
      if (above != nullptr) walls = Difference(walls, *above);
      ironed = Union(ironed, walls);
    }
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
    auto group = IronedLines(ironed, {.angle_rad = SolidAngle(options_.top_pattern),
                                      .width_nm = Width(options_.top_width_nm),
                                      .height_nm = view_.height_nm,
                                      .ironing = options_.ironing});
    if (!group.ok()) return group.status();
    Append(*std::move(group),
           {Feature::kIroning,
            options_.ironing.concentric ? FillPattern::kConcentric : FillPattern::kMonotonic,
            Area(ironed), view_.height_nm, options_.ironing.flow},
           fills);
    return absl::OkStatus();
  }

  /// Returns the bead of a bridge. `above_supports`: true if a support is below it; then it is no
  /// round strand, because strands hang below their layer and would weld to the support.
  LineBead BridgeBeadOf(bool above_supports) const {
    return BridgeBead(options_.thick_bridges && !above_supports, options_.bridge_flow,
                      options_.bridge_density);
  }
  /// Returns the bead of a bridge's round strands or of its lines. `density`: share of the bridge
  /// under its lines.
  LineBead BridgeBead(bool thick, double flow, double density) const {
    if (thick) return ThreadBead(options_.nozzle_nm, view_.height_nm, flow, density);
    return SparseBead(Width(options_.solid_width_nm), view_.height_nm, flow, density);
  }

  /// Adds the lines of each bridge region in its best direction. Regions that lines cannot span get
  /// lines along the supported boundary (FillOverhang) if the options request this.
  absl::Status AppendBridges(const MultiPolygon& regions, Fills& fills) const {
    const auto& bearers = cover_.bearers.empty() ? cover_.below : cover_.bearers;
    const MultiPolygon* below = bearers.empty() ? nullptr : bearers[0];
    for (const PolygonWithHoles& region : regions) {
      const LineBead bead = BridgeBeadOf(!view_.above_supports.empty() &&
                                         !Intersection({region}, view_.above_supports).empty());
      const auto span = SpanOf(region, below);
      RequestedFill asked{Feature::kBridgeInfill, options_.bottom_pattern, Area(region),
                          view_.height_nm, bead.share};
      FillGroup lines;
      if (options_.overhang_lines && span && !span->held) {
        asked.pattern = std::nullopt;
        lines = OverhangLines(region, *below, bead.width_nm);
      } else {
        auto solid = SolidLines(region, asked.feature, options_.bottom_pattern,
                                span ? span->angle_rad : SolidAngle(options_.bottom_pattern),
                                bead.width_nm, options_.overlap_nm, /*anchored=*/true);
        if (!solid.ok()) return solid.status();
        lines = *std::move(solid);
      }
      ScaleSections(bead.share, view_.height_nm, view_.height_nm, lines.paths);
      Append(std::move(lines), asked, fills);
    }
    return absl::OkStatus();
  }

  /// Returns true if this layer may have skins that the layer below does not have. The skins of the
  /// layer below reach one layer less high.
  bool SkinsBegin(const LayerField* field) const {
    if (IsSolidLayer(field)) return true;
    const auto& above = cover_.above;
    return above.size() < 2 || above.back() == nullptr || above.back() != above[above.size() - 2];
  }

  /// Removes from the skins the parts that need bridges between the lines of the sparse infill
  /// below, and returns them.
  absl::StatusOr<SparseBridges> BridgesOverSparse(const MultiPolygon& fill_area, Skins& skins) {
    const Coord width_nm = Width(options_.solid_width_nm);
    const MultiPolygon middles =
        BridgeMiddles(skins.solid, LeastBridgedGapNm(options_, view_.height_nm), width_nm);
    if (middles.empty()) return SparseBridges{};
    if (!under_) under_.emplace(RegionView{view_, options_, plan_, row_});
    return under_->TakeBridges(fill_area, middles, width_nm, skins);
  }

  /// Returns the bead of a bridge over sparse infill. It is a round strand only with
  /// thick_internal_bridges; thick_bridges has no effect on it.
  LineBead InternalBridgeBead() const {
    const double flow =
        options_.internal_bridge_flow > 0 ? options_.internal_bridge_flow : options_.bridge_flow;
    return BridgeBead(options_.thick_internal_bridges, flow, options_.internal_bridge_density);
  }

  /// Appends bridges between the lines of the sparse infill below.
  absl::Status AppendSparseBridges(const SparseBridges& bridges, Fills& fills) const {
    const LineBead bead = InternalBridgeBead();
    const bool own = options_.internal_bridges || options_.internal_bridge_flow > 0;
    const Feature feature = own ? Feature::kInternalBridge : Feature::kBridgeInfill;
    for (const PolygonWithHoles& region : bridges.regions) {
      const auto span = BridgeAngle(region, bridges.bearers, options_.solid_width_nm);
      auto lines = SolidLines(region, feature, FillPattern::kRectilinear,
                              span ? span->angle_rad : SolidAngle(FillPattern::kRectilinear),
                              bead.width_nm, options_.overlap_nm);
      if (!lines.ok()) return lines.status();
      ScaleSections(bead.share, view_.height_nm, view_.height_nm, lines->paths);
      Append(*std::move(lines),
             {feature, FillPattern::kRectilinear, Area(region), view_.height_nm, bead.share},
             fills);
    }
    return absl::OkStatus();
  }

  /// Returns the span of a bridge. A direction given by the options is always used, even if the
  /// lines' ends are not supported.
  std::optional<BridgeSpan> SpanOf(const PolygonWithHoles& region,
                                   const MultiPolygon* below) const {
    if (options_.bridge_angle_rad > 0) return BridgeSpan{options_.bridge_angle_rad, true};
    if (below == nullptr) return std::nullopt;
    const auto span = BridgeAngle(region, *below, options_.solid_width_nm);
    if (span && span->held) return span;
    const auto through_walls = BridgeAngle(WithWalls(region), *below, options_.solid_width_nm);
    return through_walls ? through_walls : span;
  }

  /// Returns the region together with the walls around it. If the walls of the layer below are at
  /// most as thick, they support the lines at their ends, through the walls of this layer.
  PolygonWithHoles WithWalls(const PolygonWithHoles& region) const {
    const MultiPolygon* outline = view_.OutlineAt(view_.layer);
    if (outline == nullptr || options_.walls_nm == 0) return region;
    for (PolygonWithHoles& grown : Intersection(FastOffset({region}, options_.walls_nm), *outline))
      if (Locate(region.outer.front(), grown) != Side::kOutside) return std::move(grown);
    return region;
  }

  FillGroup OverhangLines(const PolygonWithHoles& region, const MultiPolygon& below,
                          Coord width_nm) const {
    return FillOverhang(
        region, below,
        {.width_nm = width_nm, .height_nm = view_.height_nm, .overlap_nm = options_.overlap_nm});
  }

  absl::StatusOr<FillGroup> SolidLines(const PolygonWithHoles& region, Feature feature,
                                       FillPattern pattern, double angle_rad, Coord width_nm,
                                       Coord overlap_nm, bool anchored = false) const {
    return FillSolid(region, {.feature = feature,
                              .pattern = pattern,
                              .angle_rad = angle_rad,
                              .width_nm = width_nm,
                              .height_nm = view_.height_nm,
                              .layer = view_.layer,
                              .overlap_nm = overlap_nm,
                              .beside_walls = view_.stack.IsPart(),
                              .anchored = anchored});
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
                    .angle_rad = angles_.sparse_rad,
                    .layer = PatternLayer(pattern, angles_, view_.layer),
                    .z_nm = view_.z_nm,
                    .width_nm = Width(options_.sparse_width_nm),
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
    const Coord width_nm = Width(options_.sparse_width_nm);
    const double least_nm = kMinLoneWidths * static_cast<double>(width_nm);
    Append({false, MiddleLines(column, width_nm, least_nm)},
           {Feature::kInternalInfill, std::nullopt, 0, view_.height_nm, density}, fills);
  }

  /// Adds a part of the sparse infill. Beads of another height than the layer's get the width that
  /// their plastic would have in the layer.
  absl::Status AppendSparsePart(const MultiPolygon& region, const SparseFill& fill,
                                Fills& fills) const {
    if (region.empty() || (fill.field == nullptr && fill.density <= 0)) return absl::OkStatus();
    if (fill.pattern == FillPattern::kLockedZag && fill.field == nullptr)
      return AppendZones(region, fill, fills);
    auto paths = FillSparse(region, fill);
    if (!paths.ok()) return paths.status();
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
    Append({false, *std::move(paths)}, asked, fills);
    return absl::OkStatus();
  }

  /// Adds skin and skeleton of the pattern lockedzag.
  absl::Status AppendZones(const MultiPolygon& region, const SparseFill& fill, Fills& fills) const {
    absl::Status status;
    for (SparseZone& zone : LockedZones(region, fill, options_.zones)) {
      zone.fill.width_nm = Width(zone.fill.width_nm);
      status.Update(AppendSparsePart(zone.area, zone.fill, fills));
    }
    return status;
  }

  static bool IsPlain(const DensityField& density, const LayerField& field) {
    return density.dither == Dither::kNone && density.UniformAt(field.z_mm).has_value();
  }

  const SectionView& view_;
  const InfillOptions& options_;
  const PlannedInfill* plan_;
  const int32_t settings_;
  const std::optional<int32_t> row_;  ///< region of the skins; none: the whole object
  const Cover cover_;
  const FillLineAngles angles_;
  const FlowTable flows_;
  std::optional<SparseUnder> under_;  ///< made when first needed
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
