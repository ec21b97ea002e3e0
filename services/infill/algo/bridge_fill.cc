#include "services/infill/algo/bridge_fill.h"

#include <numbers>
#include <optional>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/infill_options.h"
#include "services/infill/algo/quality/line_bead.h"
#include "services/infill/algo/skins/bridge_angle.h"
#include "services/infill/algo/skins/overhang_fill.h"

namespace slicefarm::infill {
namespace {

/// Returns the bead of a bridge's round strands or of its lines. `density`: share of the bridge
/// under its lines.
LineBead BridgeBead(const RegionContext& context, bool thick, double flow, double density) {
  const InfillOptions& options = context.options;
  const Coord height_nm = context.view.height_nm;
  const Coord own_nm = options.bridges.width_nm;
  if (thick) return ThreadBead(own_nm > 0 ? own_nm : options.nozzle_nm, height_nm, flow, density);
  const Coord width_nm = own_nm > 0 ? own_nm : context.Width(options.solid_width_nm);
  return SparseBead(width_nm, height_nm, flow, density);
}

double SparseFlow(const InfillOptions& options) {
  return options.internal_bridge_flow > 0 ? options.internal_bridge_flow : options.bridge_flow;
}

/// Returns the region together with the walls around it. If the walls of the layer below are at
/// most as thick, they support the lines at their ends, through the walls of this layer.
PolygonWithHoles WithWalls(const RegionContext& context, const PolygonWithHoles& region) {
  const MultiPolygon* outline = context.view.OutlineAt(context.view.layer);
  const Coord walls_nm = context.options.walls_nm;
  if (outline == nullptr || walls_nm == 0) return region;
  for (PolygonWithHoles& grown : Intersection(FastOffset({region}, walls_nm), *outline))
    if (Locate(region.outer.front(), grown) != Side::kOutside) return std::move(grown);
  return region;
}

/// Returns the span of a bridge in its best direction.
std::optional<BridgeSpan> BestSpan(const RegionContext& context, const PolygonWithHoles& region,
                                   const MultiPolygon* below) {
  if (below == nullptr) return std::nullopt;
  const Coord width_nm = context.options.solid_width_nm;
  const auto span = BridgeAngle(region, *below, width_nm);
  if (span && span->held) return span;
  const auto through_walls = BridgeAngle(WithWalls(context, region), *below, width_nm);
  return through_walls ? through_walls : span;
}

/// Returns the span of a bridge. A direction that the options give is always used, even if the
/// lines' ends are not supported.
std::optional<BridgeSpan> SpanOf(const RegionContext& context, const PolygonWithHoles& region,
                                 const MultiPolygon* below) {
  const double given_rad = context.options.bridge_angle_rad;
  if (given_rad > 0 && !context.options.bridges.relative)
    return BridgeSpan{given_rad + context.options.turn_rad, true};
  auto span = BestSpan(context, region, below);
  if (span) span->angle_rad += given_rad;
  return span;
}

std::optional<double> AngleOf(const std::optional<BridgeSpan>& span) {
  if (!span) return std::nullopt;
  return span->angle_rad;
}

/// Returns the direction of a bridge over sparse infill.
double SparseBridgeAngle(const RegionContext& context, const PolygonWithHoles& region,
                         const MultiPolygon& bearers) {
  const BridgeOptions& options = context.options.bridges;
  if (options.internal_angle_rad > 0 && !options.relative)
    return options.internal_angle_rad + context.options.turn_rad;
  const auto span = BridgeAngle(region, bearers, context.options.solid_width_nm);
  const double best_rad = span ? span->angle_rad : context.SolidAngle(FillPattern::kRectilinear);
  return best_rad + options.internal_angle_rad;
}

/// Returns the layer's cover near a bridge: as far as walls and lines around it reach.
Cover CoverNear(const RegionContext& context, const PolygonWithHoles& region, Coord width_nm) {
  constexpr Coord kReachWidths = 20;
  const Coord reach_nm = 2 * context.options.walls_nm + kReachWidths * width_nm;
  return context.near_cover.Near(Bounds(region.outer).Grown(reach_nm));
}

/// Returns the outlines that bear the layer's bridges, or null.
const MultiPolygon* OutlineBelow(const Cover& cover) {
  const auto& bearers = cover.bearers.empty() ? cover.below : cover.bearers;
  return bearers.empty() ? nullptr : bearers[0];
}

/// Returns the lines of a bridge in a direction, or in the default direction without one.
absl::StatusOr<FillGroup> SpanningLines(const RegionContext& context,
                                        const PolygonWithHoles& region,
                                        std::optional<double> angle_rad, Coord width_nm,
                                        bool anchored) {
  const FillPattern pattern = context.options.bottom_pattern;
  SolidFill fill = context.FillOf(Feature::kBridgeInfill, pattern,
                                  angle_rad ? *angle_rad : context.SolidAngle(pattern), width_nm,
                                  context.options.overlap_nm);
  fill.anchored = anchored;
  return FillSolid(region, fill);
}

/// Adds bridges over sparse infill with lines that are turned by `turn_rad` from their direction.
absl::Status AppendTurned(const RegionContext& context, const SparseBridges& bridges,
                          const LineBead& bead, double turn_rad, Fills& fills) {
  const InfillOptions& options = context.options;
  const Coord height_nm = context.view.height_nm;
  const bool own = options.internal_bridges || options.internal_bridge_flow > 0;
  const Feature feature = own ? Feature::kInternalBridge : Feature::kBridgeInfill;
  for (const PolygonWithHoles& region : bridges.regions) {
    const double angle_rad = SparseBridgeAngle(context, region, bridges.bearers) + turn_rad;
    auto lines = FillSolid(region, context.FillOf(feature, FillPattern::kRectilinear, angle_rad,
                                                  bead.width_nm, options.overlap_nm));
    if (!lines.ok()) return lines.status();
    ScaleSections(bead.share, height_nm, height_nm, lines->paths);
    context.Append(*std::move(lines),
                   {feature, FillPattern::kRectilinear, Area(region), height_nm, bead.share},
                   fills);
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status AppendBridges(const RegionContext& context, const MultiPolygon& regions,
                           Fills& fills) {
  const InfillOptions& options = context.options;
  const MultiPolygon& supports = context.view.above_supports;
  const Coord height_nm = context.view.height_nm;
  for (const PolygonWithHoles& region : regions) {
    // Strands hang below their layer and would weld to a support.
    const bool supported = !supports.empty() && !Intersection({region}, supports).empty();
    const LineBead bead = BridgeBead(context, options.thick_bridges && !supported,
                                     options.bridge_flow, options.bridge_density);
    const Cover cover = CoverNear(context, region, bead.width_nm);
    const MultiPolygon* below = OutlineBelow(cover);
    const auto span = SpanOf(context, region, below);
    RequestedFill asked{Feature::kBridgeInfill, options.bottom_pattern, Area(region), height_nm,
                        bead.share};
    FillGroup lines;
    if (options.overhang_lines && span && !span->held) {
      asked.pattern = std::nullopt;
      lines = FillOverhang(
          region, *below,
          {.width_nm = bead.width_nm, .height_nm = height_nm, .overlap_nm = options.overlap_nm});
    } else {
      auto solid = SpanningLines(context, region, AngleOf(span), bead.width_nm, /*anchored=*/true);
      if (!solid.ok()) return solid.status();
      lines = *std::move(solid);
    }
    ScaleSections(bead.share, height_nm, height_nm, lines.paths);
    context.Append(std::move(lines), asked, fills);
  }
  return absl::OkStatus();
}

SpannedBridges::SpannedBridges(const RegionContext& context, MultiPolygon regions)
    : regions_(std::move(regions)), index_(regions_) {
  for (const PolygonWithHoles& region : regions_) {
    const Cover cover = CoverNear(context, region, context.options.solid_width_nm);
    angles_.push_back(AngleOf(SpanOf(context, region, OutlineBelow(cover))));
  }
}

SpannedBridges SpannedBridges::Below(const RegionContext& context) {
  const InfillOptions& options = context.options;
  const SectionView view = context.view.Below();
  const RegionContext below(view, context.settings, options);
  const MultiPolygon* outline = view.OutlineAt(view.layer, context.row);
  if (outline == nullptr) return {below, {}};
  Skins skins = PartFillArea(FastOffset(*outline, -options.walls_nm), *outline, below.cover,
                             {.width_nm = options.solid_width_nm, .all_solid = true});
  return {below, std::move(skins.bridge)};
}

std::optional<double> SpannedBridges::AngleUnder(const PolygonWithHoles& region) const {
  std::optional<double> angle_rad;
  double most = 0;
  for (const size_t i : index_.Meeting(Bounds(region.outer))) {
    const double borne = Area(Intersection({regions_[i]}, {region}));
    if (borne <= most) continue;
    most = borne;
    angle_rad = angles_[i];
  }
  return angle_rad;
}

absl::Status AppendSecondBridges(const RegionContext& context, const MultiPolygon& regions,
                                 const SpannedBridges& bearing, Fills& fills) {
  const Coord height_nm = context.view.height_nm;
  const LineBead bead = BridgeBead(context, /*thick=*/false, context.options.bridge_flow, 1);
  for (const PolygonWithHoles& region : regions) {
    auto lines = SpanningLines(context, region, bearing.AngleUnder(region), bead.width_nm,
                               /*anchored=*/false);
    if (!lines.ok()) return lines.status();
    ScaleSections(bead.share, height_nm, height_nm, lines->paths);
    context.Append(*std::move(lines),
                   {Feature::kBridgeInfill, context.options.bottom_pattern, Area(region), height_nm,
                    bead.share},
                   fills);
  }
  return absl::OkStatus();
}

absl::Status AppendSparseBridges(const RegionContext& context, const SparseBridges& bridges,
                                 Fills& fills) {
  const InfillOptions& options = context.options;
  return AppendTurned(context, bridges,
                      BridgeBead(context, options.thick_internal_bridges, SparseFlow(options),
                                 options.internal_bridge_density),
                      0, fills);
}

absl::Status AppendSecondSparseBridges(const RegionContext& context, const SparseBridges& bridges,
                                       Fills& fills) {
  return AppendTurned(context, bridges,
                      BridgeBead(context, /*thick=*/false, SparseFlow(context.options), 1),
                      std::numbers::pi / 2, fills);
}

}  // namespace slicefarm::infill
