#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// A place on something, and how far it is from where it was asked for.
struct Nearest {
  Point at;
  double distance_nm = 0;
};

/// A point of a tree that grows from the edge of a region. Roots have no parent.
struct LightningNode {
  Point at;
  int32_t parent = -1;

  friend bool operator==(const LightningNode&, const LightningNode&) = default;
};

/// Trees in a layer. From a layer to the one below they shrink: what is there can carry what is
/// above, as no point of the upper trees is farther than twice the layer's height from the lower
/// ones or from the region's edge.
class LightningTrees {
 public:
  const std::vector<LightningNode>& nodes() const { return nodes_; }

  /// The nearest place on a tree, with the node at its outer end. None: there is no tree.
  std::optional<std::pair<Nearest, int32_t>> NearestTo(Point p) const;

  /// A straight branch from the nearest place on a tree, or on the edge of `region` if that is
  /// nearer, to `tip`: so it lies inside. `from`: where it starts.
  Point GrowTo(Point tip, const RegionEdges& region);

  /// What is there one layer below: tips are cut back by `step_nm`, other nodes move to between
  /// their neighbours by as much at most. Cost: O(nodes).
  void Descend(double step_nm);

  /// Ties the trees to another region: what lies outside of it is cut off, and what is left is tied
  /// to the nearest edge. Cost: O(nodes), and what RegionEdges takes.
  void Refit(const RegionEdges& region);

  /// The trees as lines, each branch once: the longest way from each root, then from each fork.
  /// Those from roots begin `beyond_nm` before them.
  std::vector<Polyline> Lines(double beyond_nm) const;

 private:
  std::vector<std::vector<int32_t>> Children() const;
  void TieRoots(const RegionEdges& region);
  void CutTips(double step_nm);
  void Straighten(double step_nm);
  void DropIdleNodes();
  /// Takes out the nodes that are not kept; whose parent goes becomes a root.
  void Keep(const std::vector<char>& kept);

  std::vector<LightningNode> nodes_;
};

}  // namespace slicefarm::planning
