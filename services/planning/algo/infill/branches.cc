#include "services/planning/algo/infill/branches.h"

#include <algorithm>
#include <limits>

#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

/// What lies nearer to an edge lies on it.
constexpr double kOnEdgeNm = 1'000;
/// A node nearer than this to the line between its neighbours is not needed.
constexpr double kIdleNm = 10'000;

/// The point `way` nm from a on the way to b, which is at least as far.
Point Towards(Point a, Point b, double way) {
  const double share = way / Distance(a, b);
  return a + Point{std::llround(share * static_cast<double>(b.x - a.x)),
                   std::llround(share * static_cast<double>(b.y - a.y))};
}

bool IsInside(const MultiPolygon& region, Point p) {
  return std::ranges::any_of(region, [&](const PolygonWithHoles& island) {
    return Locate(p, island) != Side::kOutside;
  });
}

/// How far from a the way to b first meets an edge of the region, beyond what lies on the edge at
/// either end. None: it does not.
std::optional<double> FirstCrossing(const MultiPolygon& region, Point a, Point b) {
  const double length = Distance(a, b);
  double first = length - kOnEdgeNm;
  bool found = false;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point c = ring[i], d = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double turn = Cross(b - a, d - c);
      if (turn == 0) continue;
      const double along = Cross(c - a, d - c) / turn * length;
      const double aside = Cross(c - a, b - a) / turn;
      if (aside < 0 || aside > 1 || along <= kOnEdgeNm || along >= first) continue;
      first = along;
      found = true;
    }
  });
  return found ? std::optional(first) : std::nullopt;
}

}  // namespace

std::optional<Nearest> NearestOnEdge(const MultiPolygon& region, Point p) {
  Nearest best{{}, std::numeric_limits<double>::infinity()};
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point at = NearestOnSegment(p, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
      const double distance = Distance(p, at);
      if (distance < best.distance_nm) best = {at, distance};
    }
  });
  if (region.empty()) return std::nullopt;
  return best;
}

std::optional<std::pair<Nearest, int32_t>> Branches::NearestTo(Point p) const {
  if (nodes_.empty()) return std::nullopt;
  std::pair<Nearest, int32_t> best{{{}, std::numeric_limits<double>::infinity()}, -1};
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const BranchNode& node = nodes_[i];
    const Point inner = node.parent < 0 ? node.at : nodes_[static_cast<size_t>(node.parent)].at;
    const Point at = NearestOnSegment(p, inner, node.at);
    const double distance = Distance(p, at);
    if (distance < best.first.distance_nm) best = {{at, distance}, static_cast<int32_t>(i)};
  }
  return best;
}

Point Branches::GrowTo(Point tip, const MultiPolygon& region) {
  const auto edge = NearestOnEdge(region, tip);
  const auto tree = NearestTo(tip);
  const auto count = static_cast<int32_t>(nodes_.size());
  if (!tree.has_value() || (edge.has_value() && edge->distance_nm <= tree->first.distance_nm)) {
    const Point root = edge.has_value() ? edge->at : tip;
    nodes_.push_back({root, -1});
    nodes_.push_back({tip, count});
    return root;
  }
  const Point at = tree->first.at;
  BranchNode& outer = nodes_[static_cast<size_t>(tree->second)];
  if (at == outer.at) {
    nodes_.push_back({tip, tree->second});
    return at;
  }
  const BranchNode fork{at, outer.parent};
  outer.parent = count;
  nodes_.push_back(fork);
  nodes_.push_back({tip, count});
  return at;
}

void Branches::Descend(double step_nm) {
  CutTips(step_nm);
  Straighten(step_nm);
  DropIdleNodes();
}

std::vector<std::vector<int32_t>> Branches::Children() const {
  std::vector<std::vector<int32_t>> children(nodes_.size());
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].parent >= 0)
      children[static_cast<size_t>(nodes_[i].parent)].push_back(static_cast<int32_t>(i));
  return children;
}

void Branches::CutTips(double step_nm) {
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
      if (parent < 0 || --counts[static_cast<size_t>(parent)] > 0) break;  // a fork goes on
      at = static_cast<size_t>(parent);
    }
  }
  Keep(kept);
}

void Branches::Straighten(double step_nm) {
  const auto children = Children();
  std::vector<BranchNode> moved = nodes_;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent < 0 || children[i].empty()) continue;
    Point sum = nodes_[static_cast<size_t>(nodes_[i].parent)].at;
    for (const int32_t child : children[i]) sum = sum + nodes_[static_cast<size_t>(child)].at;
    const auto count = static_cast<Coord>(children[i].size() + 1);
    const Point middle{sum.x / count, sum.y / count};
    moved[i].at = Distance(nodes_[i].at, middle) <= step_nm
                      ? middle
                      : Towards(nodes_[i].at, middle, step_nm);
  }
  nodes_ = std::move(moved);
}

void Branches::DropIdleNodes() {
  const auto children = Children();
  std::vector<char> kept(nodes_.size(), 1);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const int32_t parent = nodes_[i].parent;
    if (parent < 0 || children[i].size() != 1) continue;
    BranchNode& child = nodes_[static_cast<size_t>(children[i][0])];
    if (DistanceToSegment(nodes_[i].at, nodes_[static_cast<size_t>(parent)].at, child.at) > kIdleNm)
      continue;
    // The next one up the branch is looked at with this one still in its place: as nodes go one by
    // one, no line moves by more than twice the tolerance.
    child.parent = parent;
    kept[i] = 0;
  }
  Keep(kept);
}

void Branches::Keep(const std::vector<char>& kept) {
  std::vector<int32_t> places(nodes_.size(), -1);
  std::vector<BranchNode> left;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (!kept[i]) continue;
    places[i] = static_cast<int32_t>(left.size());
    left.push_back(nodes_[i]);
  }
  for (BranchNode& node : left)
    if (node.parent >= 0) node.parent = places[static_cast<size_t>(node.parent)];
  nodes_ = std::move(left);
}

void Branches::Refit(const MultiPolygon& region) {
  const size_t count = nodes_.size();
  std::vector<char> kept(count, 1);
  std::vector<double> to_edge(count);
  for (size_t i = 0; i < count; ++i) {
    const auto edge = NearestOnEdge(region, nodes_[i].at);
    to_edge[i] = edge.has_value() ? edge->distance_nm : std::numeric_limits<double>::infinity();
    kept[i] = edge.has_value() && (to_edge[i] <= kOnEdgeNm || IsInside(region, nodes_[i].at));
  }
  for (size_t i = 0; i < count; ++i) {
    if (!kept[i]) continue;
    const Point at = nodes_[i].at;
    std::optional<Point> root;
    if (nodes_[i].parent < 0) {
      if (to_edge[i] > kOnEdgeNm) root = NearestOnEdge(region, at)->at;
    } else {
      const auto parent = static_cast<size_t>(nodes_[i].parent);
      const auto crossing = FirstCrossing(region, at, nodes_[parent].at);
      if (crossing.has_value()) {
        root = Towards(at, nodes_[parent].at, *crossing);
      } else if (!kept[parent]) {
        nodes_[i].parent = -1;  // it lies on the edge itself
      }
    }
    if (!root.has_value()) continue;
    nodes_[i].parent = static_cast<int32_t>(nodes_.size());
    nodes_.push_back({*root, -1});
    kept.push_back(1);
  }
  Keep(kept);
}

std::vector<Polyline> Branches::Lines(double beyond_nm) const {
  const auto children = Children();
  std::vector<int32_t> order;  // parents before children
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].parent < 0) order.push_back(static_cast<int32_t>(i));
  for (size_t k = 0; k < order.size(); ++k) {
    const auto& of = children[static_cast<size_t>(order[k])];
    order.insert(order.end(), of.begin(), of.end());
  }
  std::vector<double> reach(nodes_.size());       // of the longest way outwards
  std::vector<int32_t> next(nodes_.size(), -1);  // on it
  for (size_t k = order.size(); k-- > 0;) {
    const auto i = static_cast<size_t>(order[k]);
    for (const int32_t child : children[i]) {
      const double way = reach[static_cast<size_t>(child)] +
                         Distance(nodes_[i].at, nodes_[static_cast<size_t>(child)].at);
      if (next[i] >= 0 && way <= reach[i]) continue;
      reach[i] = way;
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
