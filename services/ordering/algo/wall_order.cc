#include "services/ordering/algo/wall_order.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/geometry/measure.h"
#include "services/ordering/algo/path_key.h"
#include "services/ordering/algo/wall_groups.h"

namespace slicefarm::ordering {
namespace {

/// Where loops of a contour start.
struct StartRule {
  std::optional<Point> seam;
  bool stagger = false;

  LoopPlace For(const Path& loop, Point nozzle) const {
    if (!seam) return NearestVertex(loop.points, nozzle);
    const LoopPlace place = NearestToSeam(loop.points, *seam);
    if (!stagger || loop.inset == 0) return place;
    return Further(loop.points, place, Distance(place.at, *seam));
  }
};

Leg LegOf(const Path& wall, const StartRule& rule, Point nozzle) {
  if (!wall.closed) return {StartOf(wall), EndOf(wall), wall.reversible};
  const Point at = rule.For(wall, nozzle).at;
  return {at, at, true};
}

/// Walls of one contour and inset.
void PrintLevel(const std::vector<Path*>& walls, const StartRule& rule, Route& route,
                WorkBudget& budget) {
  std::vector<Leg> legs;
  legs.reserve(walls.size());
  for (const Path* wall : walls) legs.push_back(LegOf(*wall, rule, route.at()));
  for (const Visit visit : OrderByTravel(route.To(), legs, budget)) {
    Path& wall = *walls[visit.leg];
    if (wall.closed) {
      const LoopPlace start = rule.For(wall, route.at());
      route.PrintLoop(std::move(wall), start);
    } else {
      route.Print(std::move(wall), visit.reversed);
    }
  }
}

/// The group along the island's outer contour: that of the widest box.
size_t OuterGroup(const std::vector<WallGroup>& groups) {
  const auto width = [](const WallGroup& group) {
    const Box box = Bounds(group.Outermost().points);
    return box.max.x - box.min.x;
  };
  return static_cast<size_t>(std::ranges::max_element(groups, {}, width) - groups.begin());
}

/// Turns levels, the outermost first, into the order of printing.
void Arrange(InsetOrder order, std::vector<std::vector<Path*>>& levels) {
  if (order == InsetOrder::kOuterFirst) return;
  std::reverse(levels.begin(), levels.end());
  if (order == InsetOrder::kInnerOuterInner && levels.size() > 1)
    std::swap(levels.back(), levels[levels.size() - 2]);
}

}  // namespace

void PrintWalls(std::span<Path* const> walls, const WallRules& rules, Route& route,
                WorkBudget& budget) {
  std::vector<WallGroup> groups = GroupWalls(SortedByGeometry(walls));
  std::vector<StartRule> starts;
  std::vector<Leg> legs;
  for (const WallGroup& group : groups) {
    const Path& wall = group.Outermost();
    StartRule start{.seam = {}, .stagger = rules.stagger};
    if (0 <= wall.ring && wall.ring < std::ssize(rules.seams))
      start.seam = rules.seams[static_cast<size_t>(wall.ring)];
    starts.push_back(start);
    legs.push_back(LegOf(wall, start, route.at()));
  }
  const auto print = [&](size_t i, InsetOrder order) {
    Arrange(order, groups[i].levels);
    for (const auto& level : groups[i].levels) PrintLevel(level, starts[i], route, budget);
  };
  if (rules.order != InsetOrder::kTowardsHoles) {
    for (const Visit visit : OrderByTravel(route.To(), legs, budget))
      print(visit.leg, rules.order);
    return;
  }
  if (groups.empty()) return;
  const size_t outer = OuterGroup(groups);
  print(outer, InsetOrder::kOuterFirst);
  std::swap(groups[outer], groups.back());
  std::swap(starts[outer], starts.back());
  std::swap(legs[outer], legs.back());
  legs.pop_back();
  for (const Visit visit : OrderByTravel(route.To(), legs, budget))
    print(visit.leg, InsetOrder::kInnerFirst);
}

}  // namespace slicefarm::ordering
