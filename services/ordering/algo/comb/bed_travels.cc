#include "services/ordering/algo/comb/bed_travels.h"

#include <vector>

#include "common/geometry/offset/paths_within.h"

namespace slicefarm::ordering {
namespace {

/// Adds corners to the path `from`, `corners`, `to`, so that it stays within the area after a move
/// by `shift`.
void Lead(const PathsWithin& routes, Point from, Point to, Point shift,
          std::vector<Point>& corners) {
  std::vector<Point> led;
  Point at = from + shift;
  const auto go_to = [&](Point next) {
    for (const Point corner : routes.Between(at, next)) led.push_back(corner - shift);
    at = next;
  };
  for (const Point corner : corners) {
    go_to(corner + shift);
    led.push_back(corner);
  }
  go_to(to + shift);
  corners = std::move(led);
}

/// Keeps the travels between the paths of a block within the area. `shift`: shift of the copy.
void LeadBlock(const PathsWithin& routes, Point shift, PathBlock& block) {
  if (block.spiral) return;
  for (size_t i = 1; i < block.paths.size(); ++i) {
    const Point from = EndOf(block.paths[i - 1]), to = StartOf(block.paths[i]);
    Travel travel = block.travels.empty() ? Travel{} : block.travels[i];
    const std::vector<Point> before = travel.corners;
    Lead(routes, from, to, shift, travel.corners);
    if (travel.corners == before) continue;
    travel.hidden = false;
    block.travels.resize(block.paths.size());
    block.travels[i] = std::move(travel);
  }
}

}  // namespace

void KeepInTravelArea(const MultiPolygon& travel_area, OrderedLayer& layer) {
  if (travel_area.empty()) return;
  const PathsWithin routes(travel_area);
  const auto block_of = [&](const BlockVisit& visit) -> PathBlock& {
    return layer.blocks[static_cast<size_t>(visit.block)];
  };
  for (const BlockVisit& visit : layer.visits) LeadBlock(routes, visit.shift, block_of(visit));
  for (size_t i = 1; i < layer.visits.size(); ++i) {
    const BlockVisit& before = layer.visits[i - 1];
    BlockVisit& visit = layer.visits[i];
    if (before.pass != visit.pass) continue;
    Lead(routes, EndOf(block_of(before).paths.back()) + before.shift,
         StartOf(block_of(visit).paths.front()) + visit.shift, {}, visit.corners);
  }
}

}  // namespace slicefarm::ordering
