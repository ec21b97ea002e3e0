#include "services/planning/algo/infill/lightning_trees.h"

#include <algorithm>
#include <limits>

#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

/// Distance in nm below which a point counts as on the region's boundary.
constexpr double kOnEdgeNm = 1'000;
/// A node is removed if it is nearer than this to the line between its neighbours, in nm.
constexpr double kIdleNm = 10'000;

/// Returns the point at `path` nm from a towards b. REQUIRES: b is at least that far.
Point Towards(Point a, Point b, double path) {
  const double share = path / Distance(a, b);
  return a + Point{std::llround(share * static_cast<double>(b.x - a.x)),
                   std::llround(share * static_cast<double>(b.y - a.y))};
}

/// Piece of a line, given by the distances of its ends from the line's first point.
struct LineSpan {
  double from_nm = 0;
  double to_nm = 0;
};

/// Returns the pieces of the line from a to b that are inside the region. A crossing with the
/// boundary near a or b counts as a or b.
std::vector<LineSpan> InsideSpans(const RegionEdges& region, Point a, Point b) {
  const double length = Distance(a, b);
  std::vector<double> cuts = {0, length};
  for (const RegionEdges::Edge& edge : region.Near(a, b)) {
    const Point c = edge.a, d = edge.b;
    const double turn = Cross(b - a, d - c);
    if (turn == 0) continue;
    const double along = Cross(c - a, d - c) / turn * length;
    const double aside = Cross(c - a, b - a) / turn;
    if (0 <= aside && aside <= 1 && kOnEdgeNm < along && along < length - kOnEdgeNm)
      cuts.push_back(along);
  }
  std::ranges::sort(cuts);
  std::vector<LineSpan> inside;
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] - cuts[i] <= kOnEdgeNm) continue;
    if (!region.IsInside(Towards(a, b, (cuts[i] + cuts[i + 1]) / 2))) continue;
    if (!inside.empty() && cuts[i] - inside.back().to_nm <= kOnEdgeNm) {
      inside.back().to_nm = cuts[i + 1];
    } else {
      inside.push_back({cuts[i], cuts[i + 1]});
    }
  }
  return inside;
}

}  // namespace

std::optional<std::pair<Nearest, int32_t>> LightningTrees::NearestTo(Point p) const {
  if (nodes_.empty()) return std::nullopt;
  std::pair<Nearest, int32_t> best{{{}, std::numeric_limits<double>::infinity()}, -1};
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const LightningNode& node = nodes_[i];
    const Point inner = node.parent < 0 ? node.at : nodes_[static_cast<size_t>(node.parent)].at;
    const Point at = NearestOnSegment(p, inner, node.at);
    const double distance = Distance(p, at);
    if (distance < best.first.distance_nm) best = {{at, distance}, static_cast<int32_t>(i)};
  }
  return best;
}

Point LightningTrees::GrowTo(Point tip, const RegionEdges& region) {
  const auto edge = region.Nearest(tip);
  const auto tree = NearestTo(tip);
  const auto count = static_cast<int32_t>(nodes_.size());
  if (!tree.has_value() || (edge.has_value() && edge->distance_nm <= tree->first.distance_nm)) {
    const Point root = edge.has_value() ? edge->at : tip;
    nodes_.push_back({root, -1});
    nodes_.push_back({tip, count});
    return root;
  }
  const Point at = tree->first.at;
  LightningNode& outer = nodes_[static_cast<size_t>(tree->second)];
  if (at == outer.at) {
    nodes_.push_back({tip, tree->second});
    return at;
  }
  const LightningNode fork{at, outer.parent};
  outer.parent = count;
  nodes_.push_back(fork);
  nodes_.push_back({tip, count});
  return at;
}

void LightningTrees::Descend(double prune_nm, double straighten_nm) {
  CutTips(prune_nm);
  Straighten(straighten_nm);
  DropIdleNodes();
}

std::vector<std::vector<int32_t>> LightningTrees::Children() const {
  std::vector<std::vector<int32_t>> children(nodes_.size());
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].parent >= 0)
      children[static_cast<size_t>(nodes_[i].parent)].push_back(static_cast<int32_t>(i));
  return children;
}

void LightningTrees::CutTips(double step_nm) {
  const auto children = Children();
  std::vector<size_t> counts;
  for (const auto& of : children) counts.push_back(of.size());
  std::vector<char> kept(nodes_.size(), 1);
  for (size_t tip = 0; tip < nodes_.size(); ++tip) {
    if (!children[tip].empty()) continue;
    double left = step_nm;
    for (size_t at = tip;;) {
      const int32_t parent = nodes_[at].parent;
      const double length =
          parent < 0 ? 0 : Distance(nodes_[at].at, nodes_[static_cast<size_t>(parent)].at);
      if (parent >= 0 && length > left) {
        nodes_[at].at = Towards(nodes_[at].at, nodes_[static_cast<size_t>(parent)].at, left);
        break;
      }
      kept[at] = 0;
      left -= length;
      // A fork has other branches.
      if (parent < 0 || --counts[static_cast<size_t>(parent)] > 0) break;
      at = static_cast<size_t>(parent);
    }
  }
  Keep(kept);
}

void LightningTrees::Straighten(double step_nm) {
  const auto children = Children();
  std::vector<LightningNode> moved = nodes_;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent < 0 || children[i].empty()) continue;
    Point sum = nodes_[static_cast<size_t>(nodes_[i].parent)].at;
    for (const int32_t child : children[i]) sum = sum + nodes_[static_cast<size_t>(child)].at;
    const auto count = static_cast<Coord>(children[i].size() + 1);
    const Point middle{sum.x / count, sum.y / count};
    moved[i].at =
        Distance(nodes_[i].at, middle) <= step_nm ? middle : Towards(nodes_[i].at, middle, step_nm);
  }
  nodes_ = std::move(moved);
}

void LightningTrees::DropIdleNodes() {
  auto children = Children();
  std::vector<char> kept(nodes_.size(), 1);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent < 0 || children[i].size() != 1) continue;
    const auto parent = static_cast<size_t>(nodes_[i].parent);
    const int32_t outer = children[i][0];
    LightningNode& child = nodes_[static_cast<size_t>(outer)];
    if (DistanceToSegment(nodes_[i].at, nodes_[parent].at, child.at) > kIdleNm) continue;
    child.parent = nodes_[i].parent;
    std::ranges::replace(children[parent], static_cast<int32_t>(i), outer);
    kept[i] = 0;
  }
  Keep(kept);
}

void LightningTrees::Keep(const std::vector<char>& kept) {
  std::vector<int32_t> places(nodes_.size(), -1);
  std::vector<LightningNode> left;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (!kept[i]) continue;
    places[i] = static_cast<int32_t>(left.size());
    left.push_back(nodes_[i]);
  }
  for (LightningNode& node : left)
    if (node.parent >= 0) node.parent = places[static_cast<size_t>(node.parent)];
  nodes_ = std::move(left);
}

void LightningTrees::Refit(const RegionEdges& region) {
  const size_t count = nodes_.size();
  std::vector<char> kept(count, 0);
  std::vector<LightningNode> old = nodes_;
  // Each tree edge keeps its inside pieces. A piece touches the inner end, the outer end, or
  // neither of them.
  for (size_t i = 0; i < count; ++i) {
    if (old[i].parent < 0) continue;
    const auto parent = static_cast<size_t>(old[i].parent);
    const Point inner = old[parent].at, outer = old[i].at;
    const double length = Distance(inner, outer);
    nodes_[i].parent = -1;
    for (const LineSpan& span : InsideSpans(region, inner, outer)) {
      const bool from_inner = span.from_nm <= 0, to_outer = span.to_nm >= length;
      auto base = static_cast<int32_t>(parent);
      if (from_inner) {
        kept[parent] = 1;
      } else {
        base = static_cast<int32_t>(nodes_.size());
        nodes_.push_back({Towards(inner, outer, span.from_nm), -1});
      }
      if (to_outer) {
        kept[i] = 1;
        nodes_[i].parent = base;
      } else {
        nodes_.push_back({Towards(inner, outer, span.to_nm), base});
      }
    }
  }
  kept.resize(nodes_.size(), 1);
  Keep(kept);
  TieRoots(region);
}

void LightningTrees::TieRoots(const RegionEdges& region) {
  const size_t count = nodes_.size();
  for (size_t i = 0; i < count; ++i) {
    if (nodes_[i].parent >= 0) continue;
    const auto edge = region.Nearest(nodes_[i].at);
    if (!edge.has_value() || edge->distance_nm <= kOnEdgeNm) continue;
    nodes_[i].parent = static_cast<int32_t>(nodes_.size());
    nodes_.push_back({edge->at, -1});
  }
}

std::vector<Polyline> LightningTrees::Lines(double beyond_nm) const {
  const auto children = Children();
  std::vector<int32_t> order;  // parents before children
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].parent < 0) order.push_back(static_cast<int32_t>(i));
  for (size_t k = 0; k < order.size(); ++k) {
    const auto& of = children[static_cast<size_t>(order[k])];
    order.insert(order.end(), of.begin(), of.end());
  }
  std::vector<double> reach(nodes_.size());      // length of the longest path to a leaf
  std::vector<int32_t> next(nodes_.size(), -1);  // next node on this path
  for (size_t k = order.size(); k-- > 0;) {
    const auto i = static_cast<size_t>(order[k]);
    for (const int32_t child : children[i]) {
      const double path = reach[static_cast<size_t>(child)] +
                          Distance(nodes_[i].at, nodes_[static_cast<size_t>(child)].at);
      if (next[i] >= 0 && path <= reach[i]) continue;
      reach[i] = path;
      next[i] = child;
    }
  }
  std::vector<Polyline> lines;
  const auto run = [&](std::optional<Point> from, int32_t at) {
    Polyline line;
    const auto add = [&](Point p) {
      if (line.empty() || line.back() != p) line.push_back(p);
    };
    if (from.has_value()) add(*from);
    for (; at >= 0; at = next[static_cast<size_t>(at)]) add(nodes_[static_cast<size_t>(at)].at);
    if (line.size() < 2) return;
    if (!from.has_value()) {
      const double length = Distance(line[0], line[1]);
      line[0] = Towards(line[1], line[0], length + beyond_nm);
    }
    lines.push_back(std::move(line));
  };
  for (const int32_t i : order) {
    const auto place = static_cast<size_t>(i);
    if (nodes_[place].parent < 0) run(std::nullopt, i);
    for (const int32_t child : children[place])
      if (child != next[place]) run(nodes_[place].at, child);
  }
  return lines;
}

}  // namespace slicefarm::planning
