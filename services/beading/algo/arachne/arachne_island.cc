#include "services/beading/algo/arachne/arachne_island.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/model/bead_section.h"
#include "common/model/options/beading_options.h"
#include "services/beading/algo/arachne/constant_width_walls.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading {
namespace {

/// Returns the options of the strategy for these walls. Beads are laid out as rectangles
/// (common/model/bead_section.h). Widths are therefore converted to spacings, and a stripe along
/// the outline stays free for the outer bead's round side.
StrategyOptions ForStrategy(const BeadingOptions& options, const WallPlan& plan,
                            Coord layer_height_nm) {
  const auto spacing = [&](Coord width_nm) {
    return std::max<Coord>(1, Spacing(width_nm, layer_height_nm));
  };
  StrategyOptions strategy;
  strategy.outer_width_nm = plan.external_spacing_nm;
  strategy.inner_width_nm = plan.inner_spacing_nm;
  strategy.min_width_nm = strategy.min_split_width_nm =
      spacing(plan.min_bead_nm > 0 ? plan.min_bead_nm : options.min_bead_width_nm);
  strategy.max_width_nm = spacing(options.max_bead_width_nm);
  strategy.margin_nm = (plan.external_width_nm - plan.external_spacing_nm) / 2;
  strategy.min_feature_nm = std::max<Coord>(1, options.min_feature_nm - 2 * strategy.margin_nm);
  strategy.distribution_count = options.distribution_count;
  strategy.transition_length_nm = options.transition_length_nm;
  strategy.lock_outer_width = options.lock_outer_width;
  strategy.max_walls = plan.perimeters;
  strategy.apart_nm = plan.apart_nm;
  return strategy;
}

}  // namespace

ArachneIslands::ArachneIslands(const BeadingOptions& options, const WallPlan& plan,
                               const GapFillOptions& gap_options,
                               std::function<double(double, double, double)> deciding_radius)
    : least_edge_nm_(options.least_edge_nm),
      edge_deviation_nm_(options.edge_deviation_nm),
      plan_(plan),
      gap_options_(gap_options) {
  wall_options_.deciding_radius = std::move(deciding_radius);
  wall_options_.transition_angle = options.transition_angle;
  wall_options_.transition_length_nm = options.transition_length_nm;
  wall_options_.filter_deviation_nm = options.transition_deviation_nm;
  strategy_ = MakeStrategy(ForStrategy(options, plan, gap_options.layer_height_nm));
}

Path ArachneIslands::PathOf(WallLine line) const {
  Path path;
  path.feature = line.inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter;
  path.inset = line.inset;
  path.closed = line.line.closed;
  path.points = std::move(line.line.points);
  for (const Coord spacing : line.line.thickness_nm)
    path.widths_nm.push_back(WidthToFill(spacing, gap_options_.layer_height_nm));
  const auto [least, most] = std::minmax_element(path.widths_nm.begin(), path.widths_nm.end());
  if (*least == *most) path.widths_nm.resize(1);
  return path;
}

absl::StatusOr<std::optional<IslandBeads>> ArachneIslands::Make(const PolygonWithHoles& outline,
                                                                const CancelToken& cancel) const {
  std::optional<VariableWalls> walls =
      TryWideWalls(outline, *strategy_, plan_.perimeters, wall_options_);
  if (!walls) walls = MakeVariableWalls(outline, *strategy_, wall_options_);
  if (!walls) return std::nullopt;
  IslandBeads island;
  for (WallLine& line : walls->lines) {
    if (edge_deviation_nm_ > wall_options_.tolerance_nm)
      line.line = MergeShortEdges(line.line, least_edge_nm_, edge_deviation_nm_);
    island.walls.push_back(PathOf(std::move(line)));
  }
  island.fill_area = std::move(walls->fill_area);
  if (!plan_.gap_fill) return island;
  auto gap_paths = FillNarrowParts(gap_options_, cancel, island.fill_area);
  if (!gap_paths.ok()) return gap_paths.status();
  for (Path& path : *gap_paths) island.walls.push_back(std::move(path));
  return island;
}

}  // namespace slicefarm::beading
