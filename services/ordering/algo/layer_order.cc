#include "services/ordering/algo/layer_order.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/geometry/measure.h"
#include "common/base/error.h"
#include "services/ordering/algo/fill_order.h"
#include "services/ordering/algo/path_key.h"
#include "services/ordering/algo/route.h"
#include "services/ordering/algo/travel_order.h"
#include "services/ordering/algo/wall_order.h"

namespace slicefarm::ordering {
namespace {

template <typename Visitor>
void ForEachPath(FilledIsland& island, const Visitor& visit) {
  for (Path& wall : island.walls) visit(wall);
  for (FillGroup& group : island.fills) {
    for (Path& path : group.paths) visit(path);
  }
}

absl::Status CheckPaths(FilledLayer& layer) {
  size_t bad = 0;
  for (FilledIsland& island : layer.islands) {
    ForEachPath(island, [&](const Path& path) { bad += WellFormed(path) ? 0 : 1; });
  }
  if (bad == 0) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   absl::StrCat("layer ", layer.frame.index, ": ", bad,
                                " paths with fewer than 2 points or a wrong number of widths"),
                   {{"layer", std::to_string(layer.frame.index)}});
}

/// An island on the way through the layer.
struct Stop {
  FilledIsland* island;
  Point middle;
  Point least;
};

std::vector<Stop> StopsOf(FilledLayer& layer) {
  std::vector<Stop> stops;
  for (FilledIsland& island : layer.islands) {
    Box box;
    Point least{INT64_MAX, INT64_MAX};
    ForEachPath(island, [&](const Path& path) {
      box.Add(Bounds(path.points));
      least = std::min(least, LeastPoint(path));
    });
    if (box.Empty()) continue;
    const Point middle{box.min.x + (box.max.x - box.min.x) / 2,
                       box.min.y + (box.max.y - box.min.y) / 2};
    stops.push_back({&island, middle, least});
  }
  std::stable_sort(stops.begin(), stops.end(),
                   [](const Stop& a, const Stop& b) { return a.least < b.least; });
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

InsetOrder OrderOf(const OrderingOptions& options) {
  if (options.inner_outer_inner) return InsetOrder::kInnerOuterInner;
  return options.external_perimeters_first ? InsetOrder::kOuterFirst : InsetOrder::kInnerFirst;
}

void PrintIsland(FilledIsland& island, std::optional<Point> next, const OrderingOptions& options,
                 std::span<const Point> seams, Route& route, WorkBudget& budget) {
  std::vector<Path*> walls;
  std::vector<FillBlock> gaps;
  for (Path& wall : island.walls) {
    if (wall.feature == Feature::kGapFill) {
      gaps.push_back({{&wall}});
    } else {
      walls.push_back(&wall);
    }
  }
  std::vector<FillBlock> fills = BlocksOf(island.fills);
  const WallRules rules{OrderOf(options), seams};
  if (options.infill_first) {
    PrintFills(std::move(fills), {}, route, budget);
    PrintWalls(walls, rules, route, budget);
    PrintFills(std::move(gaps), next, route, budget);
    return;
  }
  PrintWalls(walls, rules, route, budget);
  // Gap fill lies among the fills: in one order with them it costs less travel than on its own.
  std::move(gaps.begin(), gaps.end(), std::back_inserter(fills));
  PrintFills(std::move(fills), next, route, budget);
}

}  // namespace

absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        const OrderingOptions& options) {
  if (absl::Status well_formed = CheckPaths(layer); !well_formed.ok()) return well_formed;
  WorkBudget budget{options.improvement_moves};
  const std::vector<Stop> stops = StopsOf(layer);
  std::vector<Leg> legs;
  legs.reserve(stops.size());
  for (const Stop& stop : stops) legs.push_back({stop.middle, stop.middle, true});
  const std::vector<Visit> visits = OrderByTravel({plan.entry, {}}, legs, budget);

  Route route(plan.entry);
  const auto seams = options.seam == SeamPosition::kNearest ? std::span<const Point>()
                                                            : std::span<const Point>(plan.seams);
  for (size_t i = 0; i < visits.size(); ++i) {
    std::optional<Point> next;
    if (i + 1 < visits.size()) next = stops[visits[i + 1].leg].middle;
    PrintIsland(*stops[visits[i].leg].island, next, options, seams, route, budget);
  }
  return OrderedLayer{layer.frame, route.TakePaths()};
}

}  // namespace slicefarm::ordering
