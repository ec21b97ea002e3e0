#include "services/ordering/algo/comb/travel_paths.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "common/geometry/between.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::ordering {
namespace {

/// Distance of the lanes from the region's boundary, in clearances. The simplification of the lanes
/// reduces this distance by at most the tolerance. The distance exceeds 1 because an outer wall is
/// up to a third further inside where a part becomes too thin for one more bead.
constexpr double kLane = 1.5;
constexpr double kLaneTolerance = 0.15;
/// Distance between the lanes and `border_`, which is outside of them, in nm. So a travel along a
/// lane does not touch `border_`.
constexpr Coord kHair = 5'000;
/// Longest step to the nearest lane, in clearances, from a point that is too close to the boundary.
constexpr double kPathIndoors = 4;
/// Length at either end of a straight travel, in clearances, within which the travel may be close
/// to the boundary.
constexpr double kStart = 3;

Coord Times(double factor, Coord length) {
  return std::llround(factor * static_cast<double>(length));
}

/// Returns true if a tight string can bend at `corner` on its path from or to `other`: both ring
/// neighbours of the corner are on one side of the line.
bool IsTangent(Point other, Point corner, Point before, Point after) {
  return Orientation(other, corner, before) * Orientation(other, corner, after) >= 0;
}

Point Along(Point a, Point b, double length_nm) {
  const double whole = Distance(a, b);
  return whole <= length_nm ? b : PointBetween(a, b, length_nm / whole);
}

/// Returns the point on the line from a through b that is `length_nm` beyond b, or |ab| if this is
/// less. Returns b if a and b are equal.
Point Beyond(Point a, Point b, double length_nm) {
  const double whole = Distance(a, b);
  return whole > 0 ? Along(b, b + (b - a), std::min(length_nm, whole)) : b;
}

}  // namespace

MultiPolygon RegionOf(const Box& box) {
  return {{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}}};
}

TravelPaths::TravelPaths(const MultiPolygon& region, Coord clearance_nm)
    : clearance_(clearance_nm) {
  ForEachRing(region, [&](const Polygon& ring) { edge_.AddRing(ring); });
  const MultiPolygon lanes = Simplify(FastOffset(region, -Times(kLane, clearance_nm)),
                                      Times(kLaneTolerance, clearance_nm));
  ForEachRing(lanes, [&](const Polygon& ring) {
    lane_.AddRing(ring);
    lanes_.push_back(ring);
    AddNodes(ring);
  });
  ForEachRing(FastOffset(lanes, kHair), [&](const Polygon& ring) { border_.AddRing(ring); });
  for (EdgeStrips* edges : {&edge_, &border_, &lane_}) edges->Build();
  links_.resize(nodes_.size());
}

void TravelPaths::AddNodes(const Polygon& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point before = ring[i == 0 ? ring.size() - 1 : i - 1];
    const Point after = ring[i + 1 == ring.size() ? 0 : i + 1];
    // The region is to the left of the ring: a travel bends where the ring turns to the right.
    if (Orientation(before, ring[i], after) < 0) nodes_.push_back({ring[i], before, after});
  }
}

bool TravelPaths::IsClear(Point a, Point b) const {
  if (edge_.Meets(a, b)) return false;
  const double start = kStart * static_cast<double>(clearance_);
  if (Distance(a, b) <= 2 * start) return true;
  const Point from = lane_.Surrounds(a) ? a : Along(a, b, start);
  const Point to = lane_.Surrounds(b) ? b : Along(b, a, start);
  return border_.Surrounds(from) && Sees(from, to);
}

template <typename WillDo>
std::optional<Point> TravelPaths::OnLane(Point p, WillDo will_do) const {
  std::optional<Point> nearest;
  double least = kPathIndoors * static_cast<double>(clearance_);
  for (const Polygon& ring : lanes_) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point on = NearestOnSegment(p, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
      const double distance = Distance(p, on);
      if (distance >= least || !will_do(on)) continue;
      least = distance;
      nearest = on;
    }
  }
  return nearest ? std::optional(Beyond(p, *nearest, kHair)) : std::nullopt;
}

std::optional<Point> TravelPaths::Indoors(Point p) const {
  if (lane_.Surrounds(p)) return p;
  const bool in_region = edge_.Surrounds(p);
  return OnLane(p, [&](Point on) { return !in_region || !edge_.Meets(p, on); });
}

std::optional<Point> TravelPaths::FromEdge(Point p) const {
  return OnLane(p, [](Point) { return true; });
}

const std::vector<TravelPaths::Link>& TravelPaths::LinksOf(uint32_t node, WorkBudget& budget) {
  if (links_[node]) return *links_[node];
  std::vector<Link> links;
  const Node& from = nodes_[node];
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    const Node& to = nodes_[i];
    if (i == node || !IsTangent(from.at, to.at, to.before, to.after) ||
        !IsTangent(to.at, from.at, from.before, from.after)) {
      continue;
    }
    --budget.moves;
    if (Sees(from.at, to.at)) links.push_back({i, Distance(from.at, to.at)});
  }
  links_[node] = std::move(links);
  return *links_[node];
}

/// A* search. The straight distance to the goal is the lower bound of the remaining length.
class TravelPaths::Search {
 public:
  Search(TravelPaths& paths, Point from, Point to, double longest_nm, WorkBudget& budget)
      : paths_(paths),
        from_(from),
        to_(to),
        longest_(longest_nm),
        budget_(budget),
        goal_(static_cast<uint32_t>(paths.nodes_.size())),
        came_(goal_ + 1, kOpen) {}

  /// Returns the corners between start and goal, or nothing if no path exists.
  std::optional<std::vector<Point>> Run() {
    Push(kStartPlace, goal_, 0);
    const auto& nodes = paths_.nodes_;
    for (uint32_t i = 0; i < goal_; ++i)
      if (IsTangent(from_, nodes[i].at, nodes[i].before, nodes[i].after)) Push(kStartPlace, i, 0);
    while (!steps_.empty() && budget_.moves > 0) {
      const Step step = steps_.top();
      steps_.pop();
      if (came_[step.to] != kOpen || !IsOpen(step)) continue;
      came_[step.to] = step.from;
      if (step.to == goal_) return PathToGoal();
      Expand(step);
    }
    return std::nullopt;
  }

 private:
  static constexpr uint32_t kOpen = std::numeric_limits<uint32_t>::max();
  static constexpr uint32_t kStartPlace = kOpen - 1;

  struct Step {
    double bound;   ///< lower bound of the length of a path through this step
    double length;  ///< length of the path up to `to`
    uint32_t from, to;

    bool operator<(const Step& other) const {  // the greatest step is the queue's top
      return std::tie(other.bound, other.to, other.from) < std::tie(bound, to, from);
    }
  };

  Point At(uint32_t place) const {
    return place == kStartPlace ? from_ : place == goal_ ? to_ : paths_.nodes_[place].at;
  }

  void Push(uint32_t from, uint32_t to, double length_there) {
    const double length = length_there + Distance(At(from), At(to));
    const double bound = length + Distance(At(to), to_);
    if (bound <= longest_) steps_.push({bound, length, from, to});
  }

  /// Returns true if the step's line of sight is free. `LinksOf` has already checked links between
  /// nodes.
  bool IsOpen(const Step& step) {
    if (step.from != kStartPlace && step.to != goal_) return true;
    --budget_.moves;
    return paths_.Sees(At(step.from), At(step.to));
  }

  void Expand(const Step& step) {
    const Node& node = paths_.nodes_[step.to];
    if (IsTangent(to_, node.at, node.before, node.after)) Push(step.to, goal_, step.length);
    for (const Link& link : paths_.LinksOf(step.to, budget_))
      if (came_[link.to] == kOpen) Push(step.to, link.to, step.length);
  }

  std::vector<Point> PathToGoal() const {
    std::vector<Point> corners;
    for (uint32_t at = came_[goal_]; at != kStartPlace; at = came_[at]) corners.push_back(At(at));
    std::ranges::reverse(corners);
    return corners;
  }

  TravelPaths& paths_;
  Point from_, to_;
  double longest_;
  WorkBudget& budget_;
  uint32_t goal_;
  /// predecessor of each node and of the goal; kOpen: not reached yet
  std::vector<uint32_t> came_;
  std::priority_queue<Step> steps_;
};

std::optional<std::vector<Point>> TravelPaths::Find(Point a, Point b, double longest_nm,
                                                    WorkBudget& budget) {
  if (budget.moves <= 0) return std::nullopt;
  const std::optional<Point> from = Indoors(a), to = Indoors(b);
  if (!from || !to) return std::nullopt;
  const double ends = Distance(a, *from) + Distance(*to, b);
  auto corners = Search(*this, *from, *to, longest_nm - ends, budget).Run();
  if (!corners) return std::nullopt;
  std::vector<Point> path{a};
  if (*from != a) path.push_back(*from);
  path.insert(path.end(), corners->begin(), corners->end());
  if (*to != b) path.push_back(*to);
  path.push_back(b);
  // The step inside to a lane is usually unnecessary: the straight line to the next corner is
  // clear.
  if (*from != a && IsClear(path[0], path[2])) path.erase(path.begin() + 1);
  if (*to != b && path.size() > 2 && IsClear(path[path.size() - 3], b)) path.erase(path.end() - 2);
  return std::vector<Point>(path.begin() + 1, path.end() - 1);
}

}  // namespace slicefarm::ordering
