#include "services/texture/algo/paths/surface_map.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/base/portable_math.h"

namespace slicefarm::texture {
namespace {

/// Side of a triangle with its edge's vertices, the lower number first.
struct SideOfEdge {
  int32_t low = 0;
  int32_t high = 0;
  int32_t triangle = 0;
  int32_t corner = 0;

  friend auto operator<=>(const SideOfEdge&, const SideOfEdge&) = default;
};

/// Returns for each side of a triangle the triangle on its other side; -1 if there is none. `name`
/// returns the number of a vertex. Two sides are the same edge if the numbers of their vertices are
/// equal.
template <typename Name>
std::vector<std::array<int32_t, 3>> NeighboursBy(const SurfaceMesh& mesh, Name name) {
  std::vector<SideOfEdge> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = name(mesh.triangles[t][k]), b = name(mesh.triangles[t][(k + 1) % 3]);
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int32_t>(t), k});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::array<int32_t, 3>> neighbours(mesh.triangles.size(), {-1, -1, -1});
  for (size_t i = 0; i + 1 < sides.size(); ++i) {
    const SideOfEdge &one = sides[i], &other = sides[i + 1];
    if (one.low != other.low || one.high != other.high) continue;
    neighbours[one.triangle][one.corner] = other.triangle;
    neighbours[other.triangle][other.corner] = one.triangle;
    ++i;
  }
  return neighbours;
}

std::vector<Eigen::Vector3d> FaceNormals(const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(mesh.triangles.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    normals.push_back(DoubleAreaVector(mesh, t).normalized());
  return normals;
}

double AngleAt(const Eigen::Vector3d& at, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a - at, v = b - at;
  return Atan2(u.cross(v).norm(), u.dot(v));
}

/// Returns the normals of the vertices of the surface before it was cut: the mean of the adjacent
/// faces' normals, weighted by the faces' angles.
std::vector<Eigen::Vector3d> VertexNormals(const SurfaceMesh& mesh,
                                           const std::vector<Eigen::Vector3d>& faces,
                                           const std::vector<int32_t>& vertex_of) {
  std::vector<Eigen::Vector3d> sums(mesh.points_mm.size(), Eigen::Vector3d::Zero());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const double angle = AngleAt(mesh.points_mm[corners[k]], mesh.points_mm[corners[(k + 1) % 3]],
                                   mesh.points_mm[corners[(k + 2) % 3]]);
      sums[vertex_of[corners[k]]] += angle * faces[t];
    }
  }
  std::vector<Eigen::Vector3d> normals(mesh.points_mm.size());
  for (size_t v = 0; v < normals.size(); ++v) normals[v] = sums[vertex_of[v]].normalized();
  return normals;
}

/// Returns the boundary's loops. `next`: next vertex on the boundary, per vertex; -1 inside.
std::vector<std::vector<int32_t>> LoopsAlong(std::vector<int32_t> next) {
  std::vector<std::vector<int32_t>> loops;
  for (size_t start = 0; start < next.size(); ++start) {
    if (next[start] < 0) continue;
    std::vector<int32_t> loop;
    for (auto at = static_cast<int32_t>(start); next[at] >= 0;) {
      loop.push_back(at);
      at = std::exchange(next[at], -1);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

double DoubledArea(const std::vector<int32_t>& loop, const std::vector<Eigen::Vector2d>& map) {
  double area = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d &a = map[loop[i]], &b = map[loop[(i + 1) % loop.size()]];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

/// Returns the corner weights of a triangle's point closest to `p`. Source: C. Ericson, "Real-Time
/// Collision Detection", 5.1.5.
Eigen::Vector3d NearestWeights(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const double d1 = ab.dot(p - a), d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = ab.dot(p - b), d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - share, share};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

SurfaceMap::SurfaceMap(OpenedSurface opened, std::vector<Eigen::Vector2d> points_mm)
    : mesh_(std::move(opened.mesh)),
      vertex_of_(std::move(opened.vertex_of)),
      map_mm_(std::move(points_mm)) {
  neighbours_ = NeighboursBy(mesh_, [](int32_t vertex) { return vertex; });
  const auto across = NeighboursBy(mesh_, [this](int32_t vertex) { return vertex_of_[vertex]; });
  face_normals_ = FaceNormals(mesh_);
  vertex_normals_ = VertexNormals(mesh_, face_normals_, vertex_of_);
  edge_normals_.resize(mesh_.triangles.size());
  side_from_.resize(mesh_.points_mm.size());
  std::vector<int32_t> next(mesh_.points_mm.size(), -1);
  low_mm_ = high_mm_ = map_mm_[mesh_.triangles[0][0]];
  for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int32_t other = across[t][k];
      edge_normals_[t][k] =
          other < 0 ? face_normals_[t] : (face_normals_[t] + face_normals_[other]).normalized();
      const int32_t vertex = mesh_.triangles[t][k];
      low_mm_ = low_mm_.cwiseMin(map_mm_[vertex]);
      high_mm_ = high_mm_.cwiseMax(map_mm_[vertex]);
      if (neighbours_[t][k] >= 0) continue;
      next[vertex] = mesh_.triangles[t][(k + 1) % 3];
      side_from_[vertex] = {static_cast<int32_t>(t), k};
    }
  }
  loops_ = LoopsAlong(std::move(next));
  const auto outer = std::max_element(loops_.begin(), loops_.end(), [this](auto& a, auto& b) {
    return DoubledArea(a, map_mm_) < DoubledArea(b, map_mm_);
  });
  if (outer != loops_.end()) std::rotate(loops_.begin(), outer, outer + 1);
  in_loop_.resize(mesh_.points_mm.size());
  for (size_t l = 0; l < loops_.size(); ++l)
    for (size_t i = 0; i < loops_[l].size(); ++i)
      in_loop_[loops_[l][i]] = {static_cast<int32_t>(l), static_cast<int32_t>(i)};
}

Eigen::Vector2d SurfaceMap::MapPosition(const SurfacePoint& point) const {
  const auto& [a, b, c] = mesh_.triangles[point.triangle];
  return point.weights[0] * map_mm_[a] + point.weights[1] * map_mm_[b] +
         point.weights[2] * map_mm_[c];
}

Eigen::Vector3d SurfaceMap::Position(const SurfacePoint& point) const {
  const auto& [a, b, c] = mesh_.triangles[point.triangle];
  return point.weights[0] * mesh_.points_mm[a] + point.weights[1] * mesh_.points_mm[b] +
         point.weights[2] * mesh_.points_mm[c];
}

Eigen::Vector3d SurfaceMap::Normal(const SurfacePoint& point, NormalKind kind) const {
  const auto& corners = mesh_.triangles[point.triangle];
  if (kind == NormalKind::kInterpolated)
    return (point.weights[0] * vertex_normals_[corners[0]] +
            point.weights[1] * vertex_normals_[corners[1]] +
            point.weights[2] * vertex_normals_[corners[2]])
        .normalized();
  for (int k = 0; k < 3; ++k) {
    if (point.weights[k] != 0) continue;
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    if (point.weights[a] == 0) return vertex_normals_[corners[b]];
    if (point.weights[b] == 0) return vertex_normals_[corners[a]];
    return edge_normals_[point.triangle][a];
  }
  return face_normals_[point.triangle];
}

SurfacePoint SurfaceMap::NearestTo(const Eigen::Vector3d& place_mm) const {
  SurfacePoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    SurfacePoint point{
        static_cast<int32_t>(t),
        NearestWeights(place_mm, mesh_.points_mm[a], mesh_.points_mm[b], mesh_.points_mm[c])};
    const double distance = (Position(point) - place_mm).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = point;
    }
  }
  return nearest;
}

}  // namespace slicefarm::texture
