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

/// Walls of one contour and inset, towards `next`.
void PrintLevel(const std::vector<Path*>& walls, const StartRule& rule, std::optional<Point> next,
                Route& route, WorkBudget& budget) {
  std::vector<Leg> legs;
  legs.reserve(walls.size());
  for (const Path* wall : walls) legs.push_back(LegOf(*wall, rule, route.at()));
  for (const Visit visit : OrderByTravel(route.To(next), legs, budget)) {
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

/// The contours of an island, each with where its loops start.
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
      legs_.push_back(LegOf(wall, start, nozzle));
    }
  }

  bool empty() const { return groups_.empty(); }

  /// Prints the outer contour, the outermost wall first, and takes it out.
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
    std::vector<std::vector<Path*>>& levels = groups_[i].levels;
    Arrange(order, levels);
    for (const auto& level : levels) {
      const bool last = &level == &levels.back();
      PrintLevel(level, starts_[i], last ? next : starts_[i].seam, route, budget);
    }
  }

  std::vector<WallGroup> groups_;
  std::vector<StartRule> starts_;  ///< by group
  std::vector<Leg> legs_;          ///< by group
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
