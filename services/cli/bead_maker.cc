#include "services/cli/bead_maker.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numbers>
#include <optional>

#include "services/beading/algo/constant_walls.h"
#include "services/beading/algo/strategy/strategy_factory.h"
#include "services/beading/algo/wide_walls.h"

namespace slicefarm::cli {
namespace {

using beading::VariableWalls;
using beading::WallLine;

/// Walls on either side that fill any part.
constexpr int kEnoughWalls = 10'000;
/// Transitions are this many tenths of a width long: longer ones overlap less and leave more gaps.
constexpr int kTransition = 13;

}  // namespace

BeadMaker::BeadMaker(const BeadMakerOptions& options) : width_nm_(FromMm(options.width_mm)) {
  const Coord least = FromMm(options.min_feature_mm);
  beading::StrategyOptions strategy;
  strategy.outer_width_nm = strategy.inner_width_nm = width_nm_;
  strategy.min_width_nm = strategy.min_split_width_nm = strategy.min_feature_nm = least;
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
    std::optional<VariableWalls> walls;
    if (walls_ > 0) walls = beading::TryWideWalls(island, *strategy_, walls_, walls_options_);
    if (!walls) walls = beading::MakeVariableWalls(island, *strategy_, walls_options_);
    if (!walls) {
      walls = Constant(island);
      ++totals.fallbacks;
    }
    totals.diagram_s += walls->diagram_s;
    std::move(walls->lines.begin(), walls->lines.end(), std::back_inserter(lines));
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  totals.seconds += taken.count();
  ++totals.outlines;
  return lines;
}

VariableWalls BeadMaker::Constant(const PolygonWithHoles& island) const {
  beading::WallPlan plan;
  plan.perimeters = walls_ > 0 ? walls_ : kEnoughWalls;
  plan.external_width_nm = plan.inner_width_nm = width_nm_;
  plan.external_spacing_nm = plan.inner_spacing_nm = width_nm_;
  plan.gap_fill = plan.thin_walls = true;
  plan.max_gap_width_nm = 2 * width_nm_;
  const beading::IslandWalls constant = beading::MakeConstantWalls(island, plan);
  VariableWalls walls;
  for (size_t inset = 0; inset < constant.centre_lines.size(); ++inset) {
    ForEachRing(constant.centre_lines[inset], [&](const Polygon& ring) {
      const std::vector<Coord> widths(ring.size(), width_nm_);
      walls.lines.push_back({static_cast<int>(inset), false, {true, ring, widths}});
    });
  }
  return walls;
}

}  // namespace slicefarm::cli
