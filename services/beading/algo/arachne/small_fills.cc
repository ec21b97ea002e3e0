#include "services/beading/algo/arachne/small_fills.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::beading {
namespace {

/// Smallest number of beads on both sides for which inner walls exist. With fewer, the innermost
/// walls are the outermost ones too.
constexpr int kLeastWalls = 4;

/// Connected parts of the graph that belong to the infill.
class FillParts {
 public:
  FillParts(const BeadingStrategy& strategy, const SkeletalGraph& graph,
            const std::vector<int>& edge_counts)
      : strategy_(strategy),
        graph_(graph),
        edge_counts_(edge_counts),
        leaving_(graph.Leaving()),
        walls_(MostWalls(strategy)),
        least_(strategy.TransitionThickness(walls_)),
        depth_(static_cast<double>(strategy.Compute(least_, walls_ + 1).locations_nm[walls_ / 2])) {
  }

  std::vector<char> Small() {
    std::vector<char> small(graph_.nodes.size(), false);
    if (walls_ < kLeastWalls) return small;
    std::vector<char> seen(graph_.nodes.size(), false);
    for (int node = 0; node < static_cast<int>(small.size()); ++node) {
      if (seen[node] || 2 * graph_.nodes[node].radius < static_cast<double>(least_)) continue;
      const FillPart place = PartAround(node, seen);
      if (place.area >= kLeastFillNm2 || !WallsReach(place.radius)) continue;
      for (const int inside : place.nodes) small[inside] = true;
    }
    return small;
  }

 private:
  struct FillPart {
    std::vector<int> nodes;
    double area = 0;
    double radius = 0;  ///< largest radius
  };

  double Excess(int node) const { return graph_.nodes[node].radius - depth_; }

  bool IsFill(int half) const {
    return edge_counts_[half / 2] < 0 || edge_counts_[half / 2] > walls_;
  }

  /// Returns the area on both sides of an edge that is deeper than the walls. `from`, `to`: excess
  /// of the radius over the depth of the walls at the edge's ends.
  double AreaAlong(double from, double to, int half) const {
    const double length = graph_.Length(half), rise = to - from;
    const double along_outline = std::sqrt(std::max(0.0, length * length - rise * rise));
    if (to < 0) return along_outline * from * from / (from - to);
    return along_outline * (from + to);
  }

  FillPart PartAround(int start, std::vector<char>& seen) const {
    FillPart place;
    place.nodes = {start};
    seen[start] = true;
    double twice = 0;  // area of edges that are visited from both ends
    for (size_t i = 0; i < place.nodes.size(); ++i) {
      const int node = place.nodes[i];
      place.radius = std::max(place.radius, graph_.nodes[node].radius);
      graph_.ForEachLeaving(leaving_[node], [&](int half) {
        const int to = graph_.To(half);
        if (!IsFill(half)) return;
        const double area = AreaAlong(Excess(node), Excess(to), half);
        (Excess(to) > 0 ? twice : place.area) += area;
        if (Excess(to) <= 0 || seen[to]) return;
        seen[to] = true;
        place.nodes.push_back(to);
      });
    }
    place.area += twice / 2;
    return place;
  }

  /// Returns true if walls of the greatest allowed width fill a part with this radius.
  bool WallsReach(double radius) const {
    const Beading widest = strategy_.Compute(std::llround(2 * radius), walls_);
    const Beading usual = strategy_.Compute(strategy_.OptimalThickness(walls_), walls_);
    constexpr Coord kRoundingNm = 10;
    return widest.left_over_nm <= usual.left_over_nm + kRoundingNm;
  }

  const BeadingStrategy& strategy_;
  const SkeletalGraph& graph_;
  const std::vector<int>& edge_counts_;
  const std::vector<int> leaving_;
  const int walls_;     ///< largest number, both sides together
  const Coord least_;   ///< smallest thickness with a fill area
  const double depth_;  ///< distance of the fill area's border from the outline
};

}  // namespace

std::vector<char> SmallFills(const BeadingStrategy& strategy, const SkeletalGraph& graph,
                             const std::vector<int>& edge_counts) {
  return FillParts(strategy, graph, edge_counts).Small();
}

}  // namespace slicefarm::beading
