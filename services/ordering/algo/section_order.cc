#include "services/ordering/algo/section_order.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/options/ordering_options.h"
#include "services/ordering/algo/comb/island_travels.h"
#include "services/ordering/algo/comb/outside_travels.h"
#include "services/ordering/algo/fill_order.h"
#include "services/ordering/algo/loop_start.h"
#include "services/ordering/algo/path_key.h"
#include "services/ordering/algo/route.h"
#include "services/ordering/algo/unsupported_walls.h"
#include "services/ordering/algo/wall_order.h"

namespace slicefarm::ordering {
namespace {

/// Number of lines of sight that may be computed in a section, to find detours around its walls.
constexpr int64_t kSights = 50'000;

template <typename Visitor>
void ForEachPath(FilledIsland& island, const Visitor& visit) {
  for (Path& wall : island.walls) visit(wall);
  for (FillGroup& group : island.fills) {
    for (Path& path : group.paths) visit(path);
  }
}

/// An island and its position in the route through the section.
struct RouteIsland {
  FilledIsland* island;
  Point place;  ///< point that represents the island in the search for an order
  Point least;
};

/// Largest distance in nm between the seams of two layers at which the nozzle changes from one to
/// the other.
constexpr double kSeamStepNm = 1.0 * kNmPerMm;

bool HasSeamAt(Point place, const FilledIsland& island, std::span<const Point> seams) {
  return std::ranges::any_of(island.walls, [&](const Path& wall) {
    return 0 <= wall.ring && wall.ring < std::ssize(seams) &&
           Distance(seams[static_cast<size_t>(wall.ring)], place) <= kSeamStepNm;
  });
}

/// Returns the point that represents an island: the plan's entry or exit if the island has a seam
/// there, otherwise the middle of its box.
Point PlaceOf(const FilledIsland& island, const Box& box, const SectionPlan& plan) {
  if (plan.exit && HasSeamAt(*plan.exit, island, plan.seams)) return *plan.exit;
  if (HasSeamAt(plan.entry, island, plan.seams)) return plan.entry;
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

std::vector<RouteIsland> IslandsOf(FilledSection& section, const SectionPlan& plan) {
  std::vector<RouteIsland> stops;
  for (FilledIsland& island : section.islands) {
    Box box;
    Point least{INT64_MAX, INT64_MAX};
    ForEachPath(island, [&](const Path& path) {
      box.Add(Bounds(path.points));
      least = std::min(least, LeastPoint(path));
    });
    if (box.Empty()) continue;
    stops.push_back({&island, PlaceOf(island, box, plan), least});
  }
  std::stable_sort(stops.begin(), stops.end(),
                   [](const RouteIsland& a, const RouteIsland& b) { return a.least < b.least; });
  return stops;
}

std::vector<FillBlock> BlocksOf(std::vector<FillGroup>& fills) {
  std::vector<FillBlock> blocks;
  for (FillGroup& group : fills) {
    if (group.paths.empty()) continue;
    if (group.keep_order) blocks.emplace_back();
    for (Path& path : group.paths) {
      if (!group.keep_order) blocks.emplace_back();
      blocks.back().paths.push_back(&path);
    }
  }
  return blocks;
}

InsetOrder OrderOf(const WallOrder& walls) {
  if (walls.towards_holes) return InsetOrder::kTowardsHoles;
  if (walls.inner_outer_inner) return InsetOrder::kInnerOuterInner;
  return walls.external_perimeters_first ? InsetOrder::kOuterFirst : InsetOrder::kInnerFirst;
}

/// Returns the order of an island's walls. All walls of an island have the settings of one region,
/// or of regions with the same wall settings.
WallOrder OrderOf(const FilledIsland& island, const OrderingOptions& options) {
  if (island.walls.empty()) return {};
  return options.walls[static_cast<size_t>(island.walls.front().settings)];
}

/// Removes the ironing from `blocks` and returns it. Ironing passes over printed beads, so it is
/// printed last.
std::vector<FillBlock> TakeIroning(std::vector<FillBlock>& blocks) {
  std::vector<FillBlock> ironing;
  const auto is_rest = [](const FillBlock& block) {
    return block.paths.front()->feature != Feature::kIroning;
  };
  const auto rest_end = std::stable_partition(blocks.begin(), blocks.end(), is_rest);
  std::move(rest_end, blocks.end(), std::back_inserter(ironing));
  blocks.erase(rest_end, blocks.end());
  return ironing;
}

void PrintIsland(FilledIsland& island, std::optional<Point> next, const OrderingOptions& options,
                 const SectionPlan& plan, AirBelow& air, Route& route, WorkBudget& budget) {
  const WallOrder order = OrderOf(island, options);
  const WallRules rules{OrderOf(order), plan.seams, order.stagger_seams};
  std::vector<Path*> walls;
  std::vector<FillBlock> gaps;
  for (Path& wall : island.walls) {
    if (options.clockwise && wall.closed) Reverse(wall);
    if (wall.feature == Feature::kGapFill) {
      gaps.push_back({{&wall}});
    } else {
      walls.push_back(&wall);
    }
  }
  std::vector<FillBlock> fills = BlocksOf(island.fills);
  std::vector<FillBlock> ironing = TakeIroning(fills);
  std::vector<Path*> last;
  if (order.unsupported_last && !fills.empty()) last = TakeUnsupported(walls, air);
  const auto print_rest = [&] {
    if (!last.empty())
      PrintWalls(last, rules, ironing.empty() ? next : std::nullopt, route, budget);
    PrintFills(std::move(ironing), next, route, budget);
  };
  if (options.infill_first) {
    PrintFills(std::move(fills), {}, route, budget);
    PrintWalls(walls, rules, gaps.empty() ? next : std::nullopt, route, budget);
    PrintFills(std::move(gaps), next, route, budget);
    return print_rest();
  }
  const bool walls_last = fills.empty() && gaps.empty() && ironing.empty();
  PrintWalls(walls, rules, walls_last ? next : std::nullopt, route, budget);
  // Gap fill is between the fills: one order for both needs less travel than two separate orders.
  std::move(gaps.begin(), gaps.end(), std::back_inserter(fills));
  PrintFills(std::move(fills), next, route, budget);
  print_rest();
}

}  // namespace

namespace {

/// Returns the only path of a turn (loop) of a spiral, beginning at the spiral's start. Returns
/// nothing if the section is no turn of a spiral.
std::optional<PathBlock> TurnOf(FilledSection& section, const SectionPlan& plan, bool clockwise) {
  if (!plan.spiral || section.islands.size() != 1) return std::nullopt;
  FilledIsland& island = section.islands.front();
  if (island.walls.size() != 1 || !island.fills.empty() || !island.walls.front().closed)
    return std::nullopt;
  Path& loop = island.walls.front();
  if (clockwise) Reverse(loop);
  StartAt(NearestLoopPoint(loop.points, plan.spiral->start), loop);
  PathBlock block{
      .stack = section.stack, .layer = section.layer, .height_nm = section.height_nm, .paths = {}};
  block.paths.push_back(std::move(loop));
  block.spiral = plan.spiral;
  return block;
}

/// Returns the box in which travels may avoid curled areas: the bounding box of the islands. The
/// bed is at least as large.
Box BoundsOf(const FilledSection& section) {
  Box bounds;
  for (const FilledIsland& island : section.islands) bounds.Add(Bounds(island.outline.outer));
  return bounds;
}

}  // namespace

PathBlock OrderSection(FilledSection section, const SectionPlan& plan,
                       const OrderingOptions& options, WorkBudget& budget) {
  if (auto turn = TurnOf(section, plan, options.clockwise)) return *std::move(turn);
  const std::vector<RouteIsland> stops = IslandsOf(section, plan);
  std::vector<TourLeg> legs;
  legs.reserve(stops.size());
  for (const RouteIsland& stop : stops) legs.push_back({stop.place, stop.place, true});
  const std::vector<Visit> visits = OrderByTravel({plan.entry, plan.exit}, legs, budget);

  Route route(plan.entry, section.height_nm);
  std::vector<Travel> travels;
  std::optional<ExitTravel> exit_travel;
  WorkBudget sights{kSights};
  const bool looks_at_walls = options.travel.hide || options.travel.avoid_crossing;
  OutsideTravels outside(section, options.travel);
  AirBelow air(plan.air);
  std::optional<IslandEdges> left;
  std::optional<CurlAvoidance> curled;
  if (options.travel.avoid_curled && !plan.curled.empty())
    curled.emplace(plan.curled, BoundsOf(section));
  for (size_t i = 0; i < visits.size(); ++i) {
    const bool is_first = i == 0, is_last = i + 1 == visits.size();
    const std::optional<Point> next =
        !is_last ? std::optional(stops[visits[i + 1].leg].place) : plan.exit;
    FilledIsland& island = *stops[visits[i].leg].island;
    IslandEdges edges(island);
    const Barrier* known = edges.empty() ? nullptr : &edges;
    route.Enter({looks_at_walls ? known : nullptr, known, OrderOf(island, options).whole_loops});
    PrintIsland(island, next, options, plan, air, route, budget);
    const size_t first = travels.size();
    Meetings meetings;
    if (is_first) meetings.below = plan.entry;
    if (is_last) meetings.above = plan.exit;
    IslandPaths routes =
        PathsInIsland(island.outline, edges, std::span(route.paths()).subspan(first), meetings,
                      options.travel, sights, curled ? &*curled : nullptr);
    std::ranges::move(routes.travels, std::back_inserter(travels));
    if (is_last) exit_travel = std::move(routes.exit_travel);
    if (!is_first) {
      const Path& last = route.paths()[first - 1];
      const Path& path = route.paths()[first];
      Travel& travel = travels[first] = outside.Between(last, path, sights);
      if (curled) curled->KeepOff(EndOf(last), StartOf(path), sights, travel.corners);
      const std::vector<Point> points = PointsOf(EndOf(last), travel.corners, StartOf(path));
      travel.over_wall = looks_at_walls && (left->Grazes(points, 0) || edges.Grazes(points, 0));
    }
    left = std::move(edges);
  }
  if (std::ranges::all_of(travels, [](const Travel& travel) { return travel == Travel{}; }))
    travels.clear();
  return {.stack = section.stack,
          .layer = section.layer,
          .height_nm = section.height_nm,
          .paths = route.TakePaths(),
          .travels = std::move(travels),
          .exit_travel = std::move(exit_travel)};
}

}  // namespace slicefarm::ordering
