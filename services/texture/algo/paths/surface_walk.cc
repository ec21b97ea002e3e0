#include "services/texture/algo/paths/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicefarm::texture {
namespace {

constexpr double kInwards = 1e-7;  // share of their triangle by which ends are moved off edges

/// Straight line of a walk in the map. Vertices exactly on the line count as left of it.
class Course {
 public:
  Course(const SurfaceMap& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
      : map_(map), from_(from), path_(to - from) {}

  /// Returns the corner of the side by which the line leaves a triangle; -1 if the line does not
  /// pass it.
  int SideOut(int32_t triangle) const {
    const auto& corners = map_.mesh().triangles[triangle];
    for (int k = 0; k < 3; ++k)
      if (Left(corners[k]) < 0 && Left(corners[(k + 1) % 3]) >= 0) return k;
    return -1;
  }

  SurfacePoint PointOn(int32_t triangle, int corner) const {
    const auto& corners = map_.mesh().triangles[triangle];
    SurfacePoint point{triangle, Eigen::Vector3d::Zero()};
    const int next = (corner + 1) % 3;
    const double a = Left(corners[corner]), b = Left(corners[next]);
    point.weights[next] = std::clamp(a / (a - b), 0.0, 1.0);
    point.weights[corner] = 1 - point.weights[next];
    return point;
  }

  /// Returns the relative position of a point on the line.
  double ShareAt(const SurfacePoint& point) const {
    return (map_.MapPosition(point) - from_).dot(path_) / path_.squaredNorm();
  }

  /// Returns true if the line enters across the boundary side between two vertices.
  bool EntersAt(int32_t vertex, int32_t next) const { return Left(vertex) >= 0 && Left(next) < 0; }

 private:
  double Left(int32_t vertex) const {
    const Eigen::Vector2d p = map_.map_mm()[vertex] - from_;
    return path_.x() * p.y() - path_.y() * p.x();
  }

  const SurfaceMap& map_;
  Eigen::Vector2d from_;
  Eigen::Vector2d path_;
};

SurfacePoint VertexPoint(const SurfaceMap& map, int32_t vertex) {
  const auto side = map.SideFrom(vertex);
  SurfacePoint point{side.triangle, Eigen::Vector3d::Zero()};
  point.weights[side.corner] = 1;
  return point;
}

double LengthAlong(const SurfaceMap& map, const std::vector<int32_t>& vertices) {
  double length = 0;
  for (size_t i = 0; i + 1 < vertices.size(); ++i)
    length += (map.map_mm()[vertices[i + 1]] - map.map_mm()[vertices[i]]).norm();
  return length;
}

/// Returns the vertices of a loop from side `from` to side `to`, in the shorter direction.
std::vector<int32_t> AlongLoop(const SurfaceMap& map, const std::vector<int32_t>& loop,
                               int32_t from, int32_t to) {
  const auto count = static_cast<int32_t>(loop.size());
  std::vector<int32_t> forth, back;
  for (int32_t i = (from + 1) % count;; i = (i + 1) % count) {
    forth.push_back(loop[i]);
    if (i == to) break;
  }
  for (int32_t i = from;; i = (i + count - 1) % count) {
    back.push_back(loop[i]);
    if (i == (to + 1) % count) break;
  }
  return LengthAlong(map, forth) <= LengthAlong(map, back) ? forth : back;
}

/// Follows the boundary from the side where the line leaves the map to the next side where it
/// enters the map again. Returns the triangle at this side, or -1 if there is none.
int32_t GoAround(const SurfaceMap& map, const Course& course, const SurfacePoint& left_at,
                 int32_t vertex, SurfaceWalk* walk) {
  const auto place = map.InLoop(vertex);
  const std::vector<int32_t>& loop = map.loops()[place.loop];
  const double share = course.ShareAt(left_at);
  double nearest = std::numeric_limits<double>::infinity();
  int32_t back_at = -1;
  for (size_t i = 0; i < loop.size(); ++i) {
    if (!course.EntersAt(loop[i], loop[(i + 1) % loop.size()])) continue;
    const auto side = map.SideFrom(loop[i]);
    const double there = course.ShareAt(course.PointOn(side.triangle, side.corner));
    if (there < share || there >= nearest) continue;
    nearest = there;
    back_at = static_cast<int32_t>(i);
  }
  if (back_at < 0) return -1;
  walk->straight = false;
  for (const int32_t v : AlongLoop(map, loop, place.index, back_at))
    walk->between.push_back(VertexPoint(map, v));
  const auto side = map.SideFrom(loop[back_at]);
  walk->between.push_back(course.PointOn(side.triangle, side.corner));
  return side.triangle;
}

Eigen::Vector2d Inwards(const SurfaceMap& map, const SurfacePoint& point) {
  const SurfacePoint middle{point.triangle, Eigen::Vector3d::Constant(1.0 / 3)};
  const Eigen::Vector2d place = map.MapPosition(point);
  return place + kInwards * (map.MapPosition(middle) - place);
}

}  // namespace

std::optional<SurfaceWalk> WalkBetween(const SurfaceMap& map, const SurfacePoint& from,
                                       const SurfacePoint& to) {
  SurfaceWalk walk;
  if (from.triangle == to.triangle) return walk;
  const Course course(map, Inwards(map, from), Inwards(map, to));
  size_t steps = 0;
  for (int32_t at = from.triangle; at != to.triangle;) {
    const int out = course.SideOut(at);
    if (out < 0 || ++steps > map.mesh().triangles.size()) return std::nullopt;
    walk.between.push_back(course.PointOn(at, out));
    const int32_t next = map.Neighbour(at, out);
    at = next >= 0
             ? next
             : GoAround(map, course, walk.between.back(), map.mesh().triangles[at][out], &walk);
    if (at < 0) return std::nullopt;
  }
  return walk;
}

}  // namespace slicefarm::texture
