#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// Point on a tree or on a region's boundary, and its distance from the point that was asked for.
struct Nearest {
  Point at;
  double distance_nm = 0;
};

/// Node of a tree that grows from the boundary of a region. Roots have no parent.
struct LightningNode {
  Point at;
  int32_t parent = -1;

  friend bool operator==(const LightningNode&, const LightningNode&) = default;
};

/// Trees of lightning infill in one layer. The trees are computed from the top layer down, and
/// shrink from each layer to the one below. The lower trees can support the upper ones: no point of
/// an upper tree is farther than the sum of both steps of Descend from a lower tree or from the
/// region's boundary.
class LightningTrees {
 public:
  const std::vector<LightningNode>& nodes() const { return nodes_; }

  /// Returns the point on the trees that is nearest to `p`, and the index of the node at the outer
  /// end of the edge with this point. Returns nullopt if there is no tree.
  std::optional<std::pair<Nearest, int32_t>> NearestTo(Point p) const;

  /// Adds a straight branch that ends at `tip`. The branch starts at the nearest point on a tree or
  /// on the boundary of `region`, so the branch is inside the region. Returns the start.
  Point GrowTo(Point tip, const RegionEdges& region);

  /// Changes the trees to the trees of the layer below. Tips are cut back by `prune_nm`. Other
  /// nodes move towards the mean of their neighbours, by at most `straighten_nm`. Roots do not
  /// move. Cost: O(nodes).
  void Descend(double prune_nm, double straighten_nm);

  /// Fits the trees to another region. Tree pieces outside of `region` are cut off, and each
  /// remaining piece is connected to the nearest point of the region's boundary. Cost: O(nodes),
  /// plus the cost of RegionEdges.
  void Refit(const RegionEdges& region);

  /// Returns the trees as lines that contain each branch once: first the longest path from each
  /// root, then the longest path of each further branch from its fork. Lines from roots begin
  /// `beyond_nm` outside the region.
  std::vector<Polyline> Lines(double beyond_nm) const;

 private:
  std::vector<std::vector<int32_t>> Children() const;
  void TieRoots(const RegionEdges& region);
  void CutTips(double step_nm);
  void Straighten(double step_nm);
  void DropIdleNodes();
  /// Removes the nodes for which `kept` is 0. A node that loses its parent becomes a root.
  void Keep(const std::vector<char>& kept);

  std::vector<LightningNode> nodes_;
};

}  // namespace slicefarm::planning
