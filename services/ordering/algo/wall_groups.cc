#include "services/ordering/algo/wall_groups.h"

#include <algorithm>
#include <limits>
#include <map>

#include "common/geometry/measure.h"
#include "services/ordering/algo/path_key.h"

namespace slicefarm::ordering {
namespace {

struct Member {
  Path* path;
  Box box;
  size_t group;
  uint32_t index;  ///< index in its group (WallGroup::walls)
};

double DistanceToBox(Point p, const Box& box) {
  return Distance(p,
                  {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)});
}

/// Returns the distance from p to the line of `path` if it is less than `enough`, otherwise
/// `enough`.
double DistanceToPath(Point p, const Path& path, double enough) {
  const std::vector<Point>& points = path.points;
  double best = enough;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    best = std::min(best, DistanceToSegment(p, points[i], points[i + 1]));
  }
  if (path.closed) best = std::min(best, DistanceToSegment(p, points.back(), points.front()));
  return best;
}

const Member* Nearest(Point p, const std::vector<Member>& members) {
  const Member* best = nullptr;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const Member& member : members) {
    if (DistanceToBox(p, member.box) >= best_distance) continue;
    const double distance = DistanceToPath(p, *member.path, best_distance);
    if (distance >= best_distance) continue;
    best = &member;
    best_distance = distance;
  }
  return best;
}

}  // namespace

std::vector<WallGroup> GroupWalls(const std::vector<Path*>& walls) {
  std::map<int32_t, std::vector<Path*>> by_inset;
  for (Path* wall : walls) by_inset[wall->inset].push_back(wall);

  std::vector<WallGroup> groups;
  std::vector<Member> outside;
  int32_t inset_outside = -1;
  for (const auto& [inset, paths] : by_inset) {
    if (inset != inset_outside + 1) outside.clear();
    std::vector<Member> members;
    for (Path* path : paths) {
      const Member* parent = Nearest(LeastPoint(*path), outside);
      const size_t i = parent != nullptr ? parent->group : groups.size();
      if (parent == nullptr) groups.emplace_back();
      WallGroup& group = groups[i];
      const auto index = static_cast<uint32_t>(group.walls.size());
      if (parent != nullptr) group.pairs.push_back({parent->index, index});
      group.walls.push_back(path);
      members.push_back({path, Bounds(path->points), i, index});
    }
    outside = std::move(members);
    inset_outside = inset;
  }
  return groups;
}

}  // namespace slicefarm::ordering
