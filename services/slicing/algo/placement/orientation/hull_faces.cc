#include "services/slicing/algo/placement/orientation/hull_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace slicefarm::slicing {
namespace {

using Eigen::Vector3d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr size_t kExact = 20'000;
constexpr size_t kMostPoints = 12'000;  ///< largest number of points besides the selection
constexpr int kBins = 32;               ///< bins along each edge of the cube of directions
/// Smallest distance in nm outside of the first hull at which a point is kept.
constexpr double kReach = 20'000;

Vector3d AsVector(const Vertex& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// Triangulated hull, in nm.
struct Triangulation {
  std::vector<Vector3d> corners;
  std::vector<std::array<uint32_t, 3>> triangles;
  /// Index of the neighbour of each triangle across its edge from corner i to i + 1; indexed by
  /// triangle and i.
  std::vector<std::array<uint32_t, 3>> beyond;
};

Triangulation HullOfPoints(const std::vector<Vertex>& points) {
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const Vertex& v : points) {
    const Vector3d p = AsVector(v);
    input.emplace_back(p.x(), p.y(), p.z());
  }
  SurfaceMesh mesh;
  CGAL::convex_hull_3(input.begin(), input.end(), mesh);
  Triangulation hull;
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    hull.corners.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto face : mesh.faces()) {
    std::array<uint32_t, 3> corners{}, beyond{};
    auto edge = mesh.halfedge(face);
    for (int i = 0; i < 3; ++i, edge = mesh.next(edge)) {
      corners[i] = mesh.source(edge);
      beyond[i] = mesh.is_border(mesh.opposite(edge)) ? uint32_t{mesh.face(edge)}
                                                      : uint32_t{mesh.face(mesh.opposite(edge))};
    }
    hull.triangles.push_back(corners);
    hull.beyond.push_back(beyond);
  }
  return hull;
}

/// Returns the bin of the cube of directions that a vector points to.
size_t BinOf(const Vector3d& d) {
  int axis = 0;
  const double size = d.cwiseAbs().maxCoeff(&axis);
  if (size == 0) return 0;
  const auto cell = [&](double v) {
    return std::clamp(static_cast<int>((v / size + 1) * (kBins / 2)), 0, kBins - 1);
  };
  const size_t side = 2 * axis + (d[axis] < 0);
  return (side * kBins + cell(d[(axis + 1) % 3])) * kBins + cell(d[(axis + 2) % 3]);
}

constexpr size_t kBinCount = size_t{6} * kBins * kBins;

Vector3d MiddleOf(std::span<const Vertex> vertices) {
  Vector3d min = AsVector(vertices[0]), max = min;
  for (const Vertex& v : vertices) {
    min = min.cwiseMin(AsVector(v));
    max = max.cwiseMax(AsVector(v));
  }
  return (min + max) / 2;
}

/// Returns the vertex farthest from the middle in each direction of the cube's bins.
std::vector<Vertex> Selection(std::span<const Vertex> vertices, const Vector3d& middle) {
  std::vector<double> farthest(kBinCount, -1);
  std::vector<Vertex> chosen(kBinCount);
  for (const Vertex& v : vertices) {
    const Vector3d d = AsVector(v) - middle;
    const size_t bin = BinOf(d);
    if (d.squaredNorm() <= farthest[bin]) continue;
    farthest[bin] = d.squaredNorm();
    chosen[bin] = v;
  }
  std::vector<Vertex> selection;
  for (size_t i = 0; i < kBinCount; ++i)
    if (farthest[i] >= 0) selection.push_back(chosen[i]);
  return selection;
}

/// Computes the distances of points outside of a hull. It walks from triangle to triangle of the
/// hull, as seen from a point inside.
class Reach {
 public:
  explicit Reach(const Triangulation& hull) : hull_(hull), hints_(kBinCount, 0) {
    for (const Vector3d& corner : hull.corners) inside_ += corner / hull.corners.size();
  }

  double Of(const Vector3d& p) {
    const Vector3d d = p - inside_;
    uint32_t& at = hints_[BinOf(d)];
    for (size_t step = 0; step < hull_.triangles.size(); ++step) {
      const uint32_t next = Towards(at, d);
      if (next == at) break;
      at = next;
    }
    const auto& [a, b, c] = hull_.triangles[at];
    const Vector3d& corner = hull_.corners[a];
    return (hull_.corners[b] - corner)
        .cross(hull_.corners[c] - corner)
        .normalized()
        .dot(p - corner);
  }

 private:
  uint32_t Towards(uint32_t triangle, const Vector3d& d) const {
    for (int i = 0; i < 3; ++i) {
      const Vector3d from = hull_.corners[hull_.triangles[triangle][i]] - inside_;
      const Vector3d to = hull_.corners[hull_.triangles[triangle][(i + 1) % 3]] - inside_;
      if (from.cross(to).dot(d) < 0) return hull_.beyond[triangle][i];
    }
    return triangle;
  }

  const Triangulation& hull_;
  Vector3d inside_ = Vector3d::Zero();
  std::vector<uint32_t> hints_;  ///< start triangle near each direction
};

/// Returns a small subset of the vertices that has nearly the same hull.
std::vector<Vertex> Thinned(std::span<const Vertex> vertices) {
  std::vector<Vertex> points = Selection(vertices, MiddleOf(vertices));
  const Triangulation inner = HullOfPoints(points);
  if (inner.triangles.size() < 4) return points;
  Reach reach(inner);
  std::vector<std::pair<double, size_t>> outside;
  for (size_t i = 0; i < vertices.size(); ++i)
    if (const double r = reach.Of(AsVector(vertices[i])); r > kReach) outside.push_back({-r, i});
  if (outside.size() > kMostPoints) {
    std::nth_element(outside.begin(), outside.begin() + kMostPoints, outside.end());
    outside.resize(kMostPoints);
  }
  for (const auto& [r, i] : outside) points.push_back(vertices[i]);
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace

SpaceHull HullOf(std::span<const Vertex> vertices) {
  std::vector<Vertex> points(vertices.begin(), vertices.end());
  if (points.size() > kExact) points = Thinned(vertices);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const Triangulation hull = HullOfPoints(points);
  SpaceHull result;
  for (const Vector3d& corner : hull.corners) result.corners.push_back(corner / kNmPerMm);
  bool flat = !hull.triangles.empty();
  for (const auto& [a, b, c] : hull.triangles) {
    const Vector3d across =
        (result.corners[b] - result.corners[a]).cross(result.corners[c] - result.corners[a]);
    const double length = across.norm();
    if (length == 0) continue;
    result.faces.push_back({across / length, length / 2});
    flat = flat && result.faces[0].normal.dot(across) > 0.999999 * length;
  }
  const size_t one_side = result.faces.size();
  for (size_t i = 0; flat && i < one_side; ++i)
    result.faces.push_back({-result.faces[i].normal, result.faces[i].area_mm2});
  return result;
}

}  // namespace slicefarm::slicing
