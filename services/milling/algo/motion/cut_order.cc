#include "services/milling/algo/motion/cut_order.h"

#include <algorithm>

#include "common/geometry/measure.h"

namespace slicefarm::milling {
namespace {

bool HasPointOf(const PolygonWithHoles& area, const Polygon& ring) {
  return std::any_of(ring.begin(), ring.end(),
                     [&](Point p) { return Locate(p, area) != Side::kOutside; });
}

bool Overlap(const PolygonWithHoles& a, const PolygonWithHoles& b) {
  if (!Bounds(a.outer).Intersects(Bounds(b.outer))) return false;
  return HasPointOf(a, b.outer) || HasPointOf(b, a.outer);
}

/// Graph of the areas of all levels: an edge connects an area with each overlapping area of the
/// next level.
class AreaGraph {
 public:
  explicit AreaGraph(std::span<const MilledStep> levels) {
    for (uint32_t level = 0; level < levels.size(); ++level) {
      nodes_.emplace_back(levels[level].areas.size());
      for (uint32_t area = 0; level > 0 && area < nodes_[level].size(); ++area) {
        for (uint32_t above = 0; above < nodes_[level - 1].size(); ++above) {
          if (!Overlap(levels[level].areas[area].area, levels[level - 1].areas[above].area))
            continue;
          nodes_[level - 1][above].below.push_back(area);
          ++nodes_[level][area].waits_for;
        }
      }
    }
  }

  std::vector<AreaIndex> Order() {
    std::vector<AreaIndex> order;
    for (uint32_t level = 0; level < nodes_.size(); ++level)
      for (uint32_t area = 0; area < nodes_[level].size(); ++area) Visit({level, area}, order);
    return order;
  }

 private:
  struct Node {
    std::vector<uint32_t> below;  ///< indices of the overlapping areas of the next level
    uint32_t waits_for = 0;
    bool done = false;
  };

  void Visit(AreaIndex first, std::vector<AreaIndex>& order) {
    std::vector<AreaIndex> open = {first};
    while (!open.empty()) {
      const AreaIndex area = open.back();
      open.pop_back();
      Node& node = nodes_[area.level][area.area];
      if (node.done || node.waits_for > 0) continue;
      node.done = true;
      order.push_back(area);
      for (size_t i = node.below.size(); i-- > 0;) {
        --nodes_[area.level + 1][node.below[i]].waits_for;
        open.push_back({area.level + 1, node.below[i]});
      }
    }
  }

  std::vector<std::vector<Node>> nodes_;
};

}  // namespace

std::vector<AreaIndex> CutOrder(std::span<const MilledStep> levels) {
  return AreaGraph(levels).Order();
}

}  // namespace slicefarm::milling
