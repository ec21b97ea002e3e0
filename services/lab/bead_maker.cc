#include "services/lab/bead_maker.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numbers>
#include <utility>

#include "services/beading/algo/arachne/constant_width_walls.h"
#include "services/beading/algo/classic/classic_island.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::lab {
namespace {

using beading::VariableWalls;
using beading::WallLine;

/// Number of walls on each side that is enough to fill any part.
constexpr int kEnoughWalls = 10'000;
/// Length of transitions (changes of the number of beads), in tenths of a bead width. With longer
/// transitions, beads overlap less and leave more gaps.
constexpr int kTransition = 13;
/// Layer height at which beads have square sides, so that the width of a bead equals the width that
/// it fills.
constexpr Coord kFlatNm = 1;

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

WallLine LineOf(const Path& path) {
  std::vector<Coord> widths = path.widths_nm;
  widths.resize(path.points.size(), widths.back());
  return {
      path.inset, path.feature == Feature::kGapFill, {path.closed, path.points, std::move(widths)}};
}

}  // namespace

BeadMaker::BeadMaker(const BeadMakerOptions& options)
    : width_nm_(FromMm(options.width_mm)), least_nm_(FromMm(options.min_feature_mm)) {
  beading::StrategyOptions strategy;
  strategy.outer_width_nm = strategy.inner_width_nm = width_nm_;
  strategy.min_width_nm = strategy.min_split_width_nm = strategy.min_feature_nm = least_nm_;
  strategy.max_width_nm = 2 * width_nm_;
  strategy.distribution_count = 3;
  strategy.transition_length_nm = kTransition * width_nm_ / 10;
  strategy.max_walls = walls_ = options.walls;
  strategy_ = beading::MakeStrategy(strategy);
  walls_options_.transition_angle = options.transition_angle * std::numbers::pi / 180;
  walls_options_.transition_length_nm = strategy.transition_length_nm;
  walls_options_.filter_deviation_nm = width_nm_ / 5;
  walls_options_.min_middle_width_nm = width_nm_ / 5;
  walls_options_.tolerance_nm = 500;
}

std::vector<WallLine> BeadMaker::Make(const MultiPolygon& islands, BeadTotals& totals) const {
  const auto start = std::chrono::steady_clock::now();
  std::vector<WallLine> lines;
  for (const PolygonWithHoles& island : islands) {
    VariableWalls walls = MakeIsland(island, totals);
    std::move(walls.lines.begin(), walls.lines.end(), std::back_inserter(lines));
  }
  totals.seconds += SecondsSince(start);
  ++totals.outlines;
  return lines;
}

VariableWalls BeadMaker::MakeIsland(const PolygonWithHoles& island, BeadTotals& totals) const {
  if (walls_ > 0) {
    auto walls = beading::TryWideWalls(island, *strategy_, walls_, walls_options_);
    if (walls) return *std::move(walls);
  }
  const auto start = std::chrono::steady_clock::now();
  auto skeletons = beading::MakeSkeletons(island, walls_options_);
  totals.diagram_s += SecondsSince(start);
  if (skeletons) return beading::WallsAlong(*std::move(skeletons), *strategy_, walls_options_);
  ++totals.fallbacks;
  return Constant(island);
}

VariableWalls BeadMaker::Constant(const PolygonWithHoles& island) const {
  beading::WallPlan plan =
      beading::WallPlan::Make(walls_ > 0 ? walls_ : kEnoughWalls, width_nm_, width_nm_, kFlatNm);
  plan.gap_fill = plan.thin_walls = true;
  const auto beads =
      beading::MakeClassicIsland(island, plan, {least_nm_, 2 * width_nm_, kFlatNm}, CancelToken());
  VariableWalls walls;
  if (beads.ok())  // fails only if it is cancelled
    for (const Path& path : beads->walls) walls.lines.push_back(LineOf(path));
  return walls;
}

}  // namespace slicefarm::lab
