#include "services/beading/algo/arachne/beading_field.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slicefarm::beading {
namespace {

/// Layouts of beads at nodes. Wide places, which most nodes are, all have the same beads on either
/// side, so these beads are laid out once.
class NodeLayouts {
 public:
  explicit NodeLayouts(const BeadingStrategy& strategy)
      : strategy_(strategy), most_walls_(MostWalls(strategy)) {
    for (const Coord kink : strategy.Kinks()) wide_from_nm_ = std::max(wide_from_nm_, kink);
  }

  NodeBeading At(double radius, const BeadCount& count) {
    const auto thickness = static_cast<Coord>(std::llround(2 * radius));
    if (count.ratio == 0 && count.count > most_walls_ && thickness >= wide_from_nm_) {
      if (!wide_) wide_ = FromBeading(strategy_.Compute(thickness, count.count));
      return *wide_;
    }
    NodeBeading lower = FromBeading(strategy_.Compute(thickness, count.count));
    if (count.ratio == 0) return lower;
    return Between(lower, FromBeading(strategy_.Compute(thickness, count.count + 1)), count.ratio,
                   radius);
  }

 private:
  const BeadingStrategy& strategy_;
  const int most_walls_;
  Coord wide_from_nm_ = 0;
  std::optional<NodeBeading> wide_;  ///< beads where only infill is between the two sides
};

/// Node from which another node takes its beads, and the distance to it along the graph.
struct Origin {
  int node = -1;
  double distance = 0;
  int next = -1;  ///< next node on the path to the origin
};

class Field {
 public:
  Field(const SkeletalGraph& graph, const std::vector<BeadCount>& counts)
      : graph_(graph), counts_(counts), leaving_(graph.Leaving()), order_(graph.nodes.size()) {
    std::vector<std::pair<double, int>> by_radius;
    by_radius.reserve(order_.size());
    for (const SkeletalNode& node : graph_.nodes)
      by_radius.emplace_back(node.radius, static_cast<int>(by_radius.size()));
    std::sort(by_radius.begin(), by_radius.end());
    std::ranges::transform(by_radius, order_.begin(), &std::pair<double, int>::second);
  }

  /// Returns the nodes from the largest radius to the smallest.
  std::vector<int> Falling() const { return {order_.rbegin(), order_.rend()}; }

  /// Returns for each node the decided node at which its steepest path towards larger radii ends.
  std::vector<Origin> Tops() const {
    std::vector<Origin> tops = Decided();
    for (auto node = order_.rbegin(); node != order_.rend(); ++node) {
      if (tops[*node].node >= 0) continue;
      double steepest = -1;
      graph_.ForEachLeaving(leaving_[*node], [&](int half) {
        const int to = graph_.To(half);
        const double rise = graph_.nodes[to].radius - graph_.nodes[*node].radius;
        const double length = graph_.Length(half);
        const double steepness = length > 0 ? rise / length : 0;
        if (rise < 0 || tops[to].node < 0 || steepness <= steepest) return;
        steepest = steepness;
        tops[*node] = {tops[to].node, tops[to].distance + length, to};
      });
    }
    return tops;
  }

  /// Returns for each node the nearest decided node from which a path towards larger radii leads to
  /// it, if there is one.
  std::vector<Origin> Bottoms() const {
    std::vector<Origin> bottoms = Decided();
    for (const int node : order_) {
      if (counts_[node].decided()) continue;
      graph_.ForEachLeaving(leaving_[node], [&](int half) {
        const int to = graph_.To(half);
        if (bottoms[to].node < 0 || graph_.nodes[to].radius > graph_.nodes[node].radius) return;
        const double distance = bottoms[to].distance + graph_.Length(half);
        if (bottoms[node].node < 0 || distance < bottoms[node].distance)
          bottoms[node] = {bottoms[to].node, distance, to};
      });
    }
    return bottoms;
  }

 private:
  std::vector<Origin> Decided() const {
    std::vector<Origin> origins(graph_.nodes.size());
    for (size_t i = 0; i < origins.size(); ++i)
      if (counts_[i].decided()) origins[i].node = static_cast<int>(i);
    return origins;
  }

  const SkeletalGraph& graph_;
  const std::vector<BeadCount>& counts_;
  const std::vector<int> leaving_;
  std::vector<int> order_;  ///< indices of nodes, sorted by radius
};

/// Splits edges where blends end. Widths are linear from node to node, so without these nodes a
/// blend would be as long as its edge. `bottoms`: the result of Field::Bottoms.
void SplitWhereBlendsEnd(double transition_length, const std::vector<Origin>& bottoms,
                         SkeletalGraph& graph, std::vector<BeadCount>& counts,
                         std::vector<char>& central) {
  const size_t halves = graph.half_edges.size();
  for (int half = 0; half < static_cast<int>(halves); ++half) {
    const SkeletalNode from = graph.FromNode(half), to = graph.ToNode(half);
    const auto node = static_cast<size_t>(graph.half_edges[half].from);
    if (node >= bottoms.size()) continue;  // the edge was split already, from its other end
    const bool both_decided = counts[node].decided() && counts[graph.To(half)].decided();
    if (from.radius > to.radius || both_decided || bottoms[node].node < 0) continue;
    const double left = transition_length - bottoms[node].distance, length = graph.Length(half);
    if (left < kLeastPieceNm || length - left < kLeastPieceNm) continue;
    const double t = left / length;
    graph.Split(half, {{std::lerp(from.place.x(), to.place.x(), t),
                        std::lerp(from.place.y(), to.place.y(), t)},
                       std::lerp(from.radius, to.radius, t)});
    counts.emplace_back();
    central.push_back(central[half / 2]);
  }
}

}  // namespace

std::vector<NodeBeading> BeadingField(const BeadingStrategy& strategy, double transition_length_nm,
                                      SkeletalGraph& graph, std::vector<BeadCount>& counts,
                                      std::vector<char>& central) {
  std::optional<Field> field(std::in_place, graph, counts);
  std::vector<Origin> bottoms = field->Bottoms();
  const size_t nodes_before = graph.nodes.size();
  SplitWhereBlendsEnd(transition_length_nm, bottoms, graph, counts, central);
  const size_t nodes = graph.nodes.size();
  if (nodes > nodes_before) {
    field.emplace(graph, counts);
    bottoms = field->Bottoms();
  }
  std::vector<NodeBeading> beadings(nodes);
  NodeLayouts layouts(strategy);
  for (size_t i = 0; i < nodes; ++i)
    if (counts[i].decided()) beadings[i] = layouts.At(graph.nodes[i].radius, counts[i]);
  const std::vector<Origin> tops = field->Tops();
  for (const int i : field->Falling()) {
    if (counts[i].decided() || tops[i].node < 0) continue;
    if (bottoms[i].node < 0) {
      beadings[i] = beadings[tops[i].next];
      continue;
    }
    const NodeBeading& top = beadings[tops[i].node];
    const double total = tops[i].distance + bottoms[i].distance;
    const double ratio = bottoms[i].distance / std::max(1.0, std::min(total, transition_length_nm));
    beadings[i] = ratio >= 1 ? top
                             : Blend(beadings[bottoms[i].node], top, ratio,
                                     graph.nodes[bottoms[i].node].radius);
  }
  return beadings;
}

}  // namespace slicefarm::beading
