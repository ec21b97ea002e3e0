#include "services/ordering/algo/fill_order.h"

#include <utility>

#include "services/ordering/algo/path_key.h"

namespace slicefarm::ordering {
namespace {

/// Returns the blocks sorted by the geometry of their first paths.
std::vector<FillBlock> Sorted(std::vector<FillBlock> blocks) {
  std::vector<Path*> firsts;
  firsts.reserve(blocks.size());
  for (const FillBlock& block : blocks) firsts.push_back(block.paths.front());
  std::vector<FillBlock> sorted;
  sorted.reserve(blocks.size());
  for (const size_t i : OrderByGeometry(firsts)) sorted.push_back(std::move(blocks[i]));
  return sorted;
}

bool IsLoop(const FillBlock& block) { return block.paths.size() == 1 && block.paths[0]->closed; }

TourLeg TourLegOf(const FillBlock& block, Point nozzle) {
  if (IsLoop(block)) {
    const Point at = NearestVertex(block.paths[0]->points, nozzle).at;
    return {at, at, true};
  }
  const bool reversible = block.paths.size() == 1 && block.paths[0]->reversible;
  return {StartOf(*block.paths.front()), EndOf(*block.paths.back()), reversible};
}

void PrintBlock(FillBlock block, bool reversed, Route& route) {
  if (IsLoop(block)) {
    Path& loop = *block.paths[0];
    const LoopPoint start = NearestVertex(loop.points, route.at());
    route.PrintLoop(std::move(loop), start);
    return;
  }
  for (Path* path : block.paths) route.Print(std::move(*path), reversed);
}

}  // namespace

void PrintFills(std::vector<FillBlock> blocks, std::optional<Point> next, Route& route,
                WorkBudget& budget) {
  blocks = Sorted(std::move(blocks));
  std::vector<TourLeg> legs;
  legs.reserve(blocks.size());
  for (const FillBlock& block : blocks) legs.push_back(TourLegOf(block, route.at()));
  for (const Visit visit : OrderByTravel(route.To(next), legs, budget)) {
    PrintBlock(std::move(blocks[visit.leg]), visit.reversed, route);
  }
}

}  // namespace slicefarm::ordering
