#include "services/planning/algo/infill/bodies.h"

#include <cstdint>

#include "common/base/disjoint_sets.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

/// Islands of one layer, with their numbers among the islands of all layers.
struct LayerIslands {
  const MultiPolygon& islands;
  int32_t first = 0;  ///< number of the first island
  std::vector<Box> boxes;
};

std::vector<LayerIslands> IslandsOf(const ObjectStack& stack) {
  std::vector<LayerIslands> layers;
  int32_t count = 0;
  for (const StackLayer& layer : stack) {
    LayerIslands& added = layers.emplace_back(LayerIslands{layer.whole, count, {}});
    for (const PolygonWithHoles& island : layer.whole) added.boxes.push_back(Bounds(island.outer));
    count += static_cast<int32_t>(layer.whole.size());
  }
  return layers;
}

/// Joins the islands of a layer with the islands below that they overlap.
void JoinWithBelow(const LayerIslands& layer, const LayerIslands& below, DisjointSets& bodies) {
  const auto join = [&](size_t a, size_t b) {
    bodies.Join(layer.first + static_cast<int32_t>(a), below.first + static_cast<int32_t>(b));
  };
  const bool same = layer.islands == below.islands;
  for (size_t a = 0; a < layer.islands.size(); ++a) {
    if (same) {
      join(a, a);
      continue;
    }
    for (size_t b = 0; b < below.islands.size(); ++b)
      if (layer.boxes[a].Intersects(below.boxes[b]) &&
          !Intersection({layer.islands[a]}, {below.islands[b]}).empty())
        join(a, b);
  }
}

}  // namespace

std::vector<std::vector<Point>> BodyMiddles(const ObjectStack& stack) {
  if (stack.empty()) return {};
  const std::vector<LayerIslands> layers = IslandsOf(stack);
  const int32_t count = layers.back().first + static_cast<int32_t>(layers.back().islands.size());
  DisjointSets bodies(count);
  for (size_t i = 1; i < layers.size(); ++i) JoinWithBelow(layers[i], layers[i - 1], bodies);
  std::vector<Box> of_body(static_cast<size_t>(count));
  const auto body = [&](const LayerIslands& layer, size_t island) -> Box& {
    return of_body[static_cast<size_t>(bodies.RootOf(layer.first + static_cast<int32_t>(island)))];
  };
  for (const LayerIslands& layer : layers)
    for (size_t a = 0; a < layer.boxes.size(); ++a) body(layer, a).Add(layer.boxes[a]);
  std::vector<std::vector<Point>> middles(stack.size());
  for (size_t i = 0; i < layers.size(); ++i) {
    for (size_t a = 0; a < layers[i].boxes.size(); ++a) {
      const Box& box = body(layers[i], a);
      middles[i].push_back({(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2});
    }
  }
  return middles;
}

}  // namespace slicefarm::planning
