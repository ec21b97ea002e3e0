#include "services/texture/algo/surface/disk.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/base/error.h"
#include "services/texture/algo/surface/corner_fans.h"

namespace slicefarm::texture {
namespace {

/// Side of a triangle, from its first vertex to its second.
struct Side {
  int32_t from = 0;
  int32_t to = 0;

  friend auto operator<=>(const Side&, const Side&) = default;
};

absl::Status Malformed(std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, what);
}

std::string PlaceOf(const SurfaceMesh& mesh, int32_t vertex) {
  const Eigen::Vector3d& p = mesh.points_mm[vertex];
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", p.x(), p.y(), p.z());
}

absl::Status CheckNumbers(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "the surface has no triangles");
  for (size_t i = 0; i < mesh.points_mm.size(); ++i) {
    if (!mesh.points_mm[i].allFinite())
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshNotFinite,
                       fmt::format("vertex {} has a coordinate that is not a number", i + 1));
  }
  const auto points = static_cast<int32_t>(mesh.points_mm.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int32_t vertex : mesh.triangles[t]) {
      if (vertex < 0 || vertex >= points)
        return Malformed(fmt::format("triangle {} refers to vertex {} of {}", t + 1,
                                     static_cast<int64_t>(vertex) + 1, points));
    }
    if (DoubleAreaVector(mesh, t).squaredNorm() <= 0)
      return Malformed(
          fmt::format("triangle {} at {} has no area", t + 1, PlaceOf(mesh, mesh.triangles[t][0])));
  }
  return absl::OkStatus();
}

/// Returns all sides, sorted. Errors: a side that two triangles have in the same direction.
absl::StatusOr<std::vector<Side>> SidesOf(const SurfaceMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sides.push_back({triangle[k], triangle[(k + 1) % 3]});
  }
  std::sort(sides.begin(), sides.end());
  const auto twice = std::adjacent_find(sides.begin(), sides.end());
  if (twice != sides.end())
    return Malformed(
        fmt::format("the edge from {} to {} belongs to more than two triangles, or its two "
                    "triangles have opposite orientations",
                    PlaceOf(mesh, twice->from), PlaceOf(mesh, twice->to)));
  return sides;
}

/// Returns the next boundary vertex after each vertex; -1 for a vertex inside. Each vertex must
/// have one fan of triangles.
std::vector<int32_t> NextOnBoundary(size_t vertices, const std::vector<Side>& sides) {
  std::vector<int32_t> next(vertices, -1);
  for (const Side& side : sides) {
    if (!std::binary_search(sides.begin(), sides.end(), Side{side.to, side.from}))
      next[side.from] = side.to;
  }
  return next;
}

double LengthOf(const SurfaceMesh& mesh, const BoundaryLoop& loop) {
  double length = 0;
  for (size_t i = 0; i < loop.size(); ++i)
    length += (mesh.points_mm[loop[(i + 1) % loop.size()]] - mesh.points_mm[loop[i]]).norm();
  return length;
}

std::vector<BoundaryLoop> LoopsOf(const SurfaceMesh& mesh, std::vector<int32_t> next) {
  std::vector<BoundaryLoop> loops;
  for (int32_t first = 0; first < static_cast<int32_t>(next.size()); ++first) {
    if (next[first] < 0) continue;
    BoundaryLoop& loop = loops.emplace_back();
    for (int32_t at = first; next[at] >= 0; at = std::exchange(next[at], -1)) loop.push_back(at);
  }
  const auto longest = std::max_element(
      loops.begin(), loops.end(),
      [&](const auto& a, const auto& b) { return LengthOf(mesh, a) < LengthOf(mesh, b); });
  if (longest != loops.end()) std::iter_swap(loops.begin(), longest);
  return loops;
}

/// Returns a vertex at which several fans of triangles meet, if there is one.
std::optional<int32_t> VertexOfSeveralFans(const SurfaceMesh& mesh) {
  DisjointSets fans = CornerFans(mesh, {});
  std::vector<int32_t> first_corner(mesh.points_mm.size(), -1);
  for (int32_t corner = 0; corner < static_cast<int32_t>(3 * mesh.triangles.size()); ++corner) {
    const int32_t vertex = mesh.triangles[corner / 3][corner % 3];
    if (first_corner[vertex] < 0) first_corner[vertex] = corner;
    if (!fans.AreJoined(first_corner[vertex], corner)) return vertex;
  }
  return std::nullopt;
}

struct Counts {
  int64_t components = 0;
  int64_t vertices = 0;  ///< number of vertices that triangles use
};

Counts CountsOf(const SurfaceMesh& mesh) {
  DisjointSets sets(static_cast<int32_t>(mesh.points_mm.size()));
  std::vector<bool> used(mesh.points_mm.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const int32_t vertex : triangle) {
      used[vertex] = true;
      sets.Join(vertex, triangle[0]);
    }
  }
  const auto unused = std::count(used.begin(), used.end(), false);
  return {sets.sets() - unused, static_cast<int64_t>(used.size()) - unused};
}

}  // namespace

absl::StatusOr<SurfaceTopology> TopologyOf(const SurfaceMesh& mesh) {
  if (absl::Status status = CheckNumbers(mesh); !status.ok()) return status;
  const auto sides = SidesOf(mesh);
  if (!sides.ok()) return sides.status();
  if (const auto vertex = VertexOfSeveralFans(mesh); vertex.has_value())
    return Malformed(
        fmt::format("parts of the surface touch only at the vertex {}", PlaceOf(mesh, *vertex)));
  const Counts counts = CountsOf(mesh);
  if (counts.components != 1)
    return Malformed(fmt::format("the surface has {} separate parts", counts.components));
  std::vector<int32_t> next = NextOnBoundary(mesh.points_mm.size(), *sides);
  const auto bounds = std::count_if(next.begin(), next.end(), [](int32_t to) { return to >= 0; });
  SurfaceTopology topology;
  topology.loops = LoopsOf(mesh, std::move(next));
  const auto triangles = static_cast<int64_t>(mesh.triangles.size());
  const int64_t edges = (3 * triangles + bounds) / 2;
  const int64_t euler = counts.vertices - edges + triangles;
  topology.handles = (2 - static_cast<int64_t>(topology.loops.size()) - euler) / 2;
  return topology;
}

absl::StatusOr<std::vector<BoundaryLoop>> BoundaryOfDisk(const SurfaceMesh& mesh) {
  auto topology = TopologyOf(mesh);
  if (!topology.ok()) return topology.status();
  if (topology->loops.empty())
    return Malformed("the surface is closed: a seam must be cut before it can be flattened");
  if (topology->handles != 0)
    return Malformed(
        fmt::format("the surface has handles ({}): seams must be cut before it can be flattened",
                    topology->handles));
  return std::move(topology->loops);
}

}  // namespace slicefarm::texture
