#include "services/ordering/algo/wall_order.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/geometry/measure.h"
#include "services/ordering/algo/path_key.h"
#include "services/ordering/algo/wall_groups.h"

namespace slicefarm::ordering {
namespace {

/// Rule for the start of a contour's loops.
struct StartRule {
  std::optional<Point> seam;
  bool stagger = false;

  LoopPoint For(const Path& loop, Point nozzle) const {
    if (!seam) return NearestVertex(loop.points, nozzle);
    const LoopPoint start = NearestToSeam(loop.points, *seam);
    if (!stagger || loop.inset == 0) return start;
    return Further(loop.points, start, Distance(start.at, *seam));
  }
};

TourLeg TourLegOf(const Path& wall, const StartRule& rule, Point nozzle) {
  if (!wall.closed) return {StartOf(wall), EndOf(wall), wall.reversible};
  const Point at = rule.For(wall, nozzle).at;
  return {at, at, true};
}

/// Returns the group along the island's outer contour: the group with the widest box.
size_t OuterGroup(const std::vector<WallGroup>& groups) {
  const auto width = [](const WallGroup& group) {
    const Box box = Bounds(group.Outermost().points);
    return box.max.x - box.min.x;
  };
  return static_cast<size_t>(std::ranges::max_element(groups, {}, width) - groups.begin());
}

/// Returns the rules for the order of a contour's walls.
std::vector<Precedence> PrecedenceOf(const WallGroup& group, InsetOrder order) {
  std::vector<Precedence> rules;
  for (const auto [outer, inner] : group.pairs) {
    const bool outer_first =
        order == InsetOrder::kOuterFirst ||
        (order == InsetOrder::kInnerOuterInner && group.walls[outer]->inset == 0);
    rules.push_back(outer_first ? Precedence{outer, inner} : Precedence{inner, outer});
  }
  if (order != InsetOrder::kInnerOuterInner) return rules;
  // The second wall is printed last: all walls inside of it are printed before the outermost wall.
  for (const auto [outer, second] : group.pairs)
    for (const auto [middle, third] : group.pairs)
      if (middle == second && group.walls[outer]->inset == 0) rules.push_back({third, outer});
  return rules;
}

/// Contours of an island that are not printed yet, each with the start of its loops.
class Contours {
 public:
  Contours(std::span<Path* const> walls, const WallRules& rules, Point nozzle)
      : groups_(GroupWalls(SortedByGeometry(walls))) {
    for (const WallGroup& group : groups_) {
      const Path& wall = group.Outermost();
      StartRule start{.seam = {}, .stagger = rules.stagger};
      if (0 <= wall.ring && wall.ring < std::ssize(rules.seams))
        start.seam = rules.seams[static_cast<size_t>(wall.ring)];
      starts_.push_back(start);
      legs_.push_back(TourLegOf(wall, start, nozzle));
    }
  }

  bool empty() const { return groups_.empty(); }

  /// Prints the outer contour, the outermost wall first, and removes it from the contours.
  void TakeOuter(Route& route, WorkBudget& budget) {
    const size_t outer = OuterGroup(groups_);
    Print(outer, InsetOrder::kOuterFirst, {}, route, budget);
    groups_.erase(groups_.begin() + static_cast<ptrdiff_t>(outer));
    starts_.erase(starts_.begin() + static_cast<ptrdiff_t>(outer));
    legs_.erase(legs_.begin() + static_cast<ptrdiff_t>(outer));
  }

  void PrintAll(InsetOrder order, std::optional<Point> next, Route& route, WorkBudget& budget) {
    const std::vector<Visit> visits = OrderByTravel(route.To(next), legs_, budget);
    for (size_t i = 0; i < visits.size(); ++i) {
      const bool last = i + 1 == visits.size();
      Print(visits[i].leg, order, last ? next : legs_[visits[i + 1].leg].start, route, budget);
    }
  }

 private:
  void Print(size_t i, InsetOrder order, std::optional<Point> next, Route& route,
             WorkBudget& budget) {
    const WallGroup& group = groups_[i];
    const std::vector<Precedence> precedence = PrecedenceOf(group, order);
    std::vector<TourLeg> legs;
    legs.reserve(group.walls.size());
    for (const Path* wall : group.walls) legs.push_back(TourLegOf(*wall, starts_[i], route.at()));
    Journey journey = route.To(next);
    journey.precedence = precedence;
    for (const Visit visit : OrderByTravel(journey, legs, budget)) {
      Path& wall = *group.walls[visit.leg];
      if (wall.closed) {
        const LoopPoint start = starts_[i].For(wall, route.at());
        route.PrintLoop(std::move(wall), start);
      } else {
        route.Print(std::move(wall), visit.reversed);
      }
    }
  }

  std::vector<WallGroup> groups_;
  std::vector<StartRule> starts_;  ///< start rule of each group
  std::vector<TourLeg> legs_;      ///< leg of each group
};

}  // namespace

void PrintWalls(std::span<Path* const> walls, const WallRules& rules, std::optional<Point> next,
                Route& route, WorkBudget& budget) {
  Contours contours(walls, rules, route.at());
  InsetOrder order = rules.order;
  if (order == InsetOrder::kTowardsHoles && !contours.empty()) {
    contours.TakeOuter(route, budget);
    order = InsetOrder::kInnerFirst;
  }
  contours.PrintAll(order, next, route, budget);
}

}  // namespace slicefarm::ordering
