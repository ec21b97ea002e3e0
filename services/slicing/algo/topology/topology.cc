#include "services/slicing/algo/topology/topology.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/topology/edge_fans.h"
#include "services/slicing/algo/topology/face_orientation.h"
#include "services/slicing/algo/topology/mesh_measure.h"

namespace slicefarm::slicing {
namespace {

/// Drops faces with two equal corners and returns their number.
int64_t DropCollapsedFaces(std::vector<Triangle>& triangles) {
  return static_cast<int64_t>(std::erase_if(
      triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }));
}

/// Keeps the first of several faces with the same corners and orientation. Returns the number
/// of removed faces. Two faces back to back are both kept. Cost: O(n log n).
int64_t DropRepeatedFaces(std::vector<Triangle>& triangles) {
  struct Key {
    Triangle corners;  ///< the smallest index first
    uint32_t face = 0;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<Key> keys(triangles.size());
  for (uint32_t face = 0; face < keys.size(); ++face) {
    Triangle corners = triangles[face];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    keys[face] = {corners, face};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(triangles.size());
  for (size_t i = 1; i < keys.size(); ++i)
    repeated[keys[i].face] = keys[i].corners == keys[i - 1].corners;
  uint32_t face = 0;
  return static_cast<int64_t>(
      std::erase_if(triangles, [&](const Triangle&) { return repeated[face++]; }));
}

/// Removes repeated faces and returns the edge table of the remaining faces. Adds the number of
/// removed faces to `repeated`. Repeated faces are searched only if an edge has more than two
/// faces, or two faces in the same direction.
EdgeTable EdgesOfDistinct(IndexedMesh& mesh, int64_t& repeated) {
  EdgeTable table = BuildEdgeTable(mesh.triangles, mesh.vertices.size());
  if (table.fan_count() == 0 && table.conflicts == 0) return table;
  const int64_t dropped = DropRepeatedFaces(mesh.triangles);
  if (dropped == 0) return table;
  repeated += dropped;
  return BuildEdgeTable(mesh.triangles, mesh.vertices.size());
}

/// Returns the missing faces. Three open half-edges that form a triangle give a face in the
/// opposite direction, unless all three belong to one single face. Cost: O(h + n log n) for h
/// half-edges, n of them open.
std::vector<Triangle> MissingFaces(const IndexedMesh& mesh, const EdgeTable& table) {
  std::vector<bool> in_fan(table.twins.size());
  for (const uint32_t h : table.fans) in_fan[h] = true;
  std::map<uint32_t, std::vector<uint32_t>> from;  // open half-edges per origin
  for (uint32_t h = 0; h < table.twins.size(); ++h)
    if (table.twins[h] == kNoTwin && !in_fan[h]) from[OriginOf(mesh.triangles, h)].push_back(h);
  // Returns the only open half-edge that starts where `h` ends; kNoTwin if there is none or more
  // than one.
  const auto next = [&](uint32_t h) {
    const auto found = from.find(TargetOf(mesh.triangles, h));
    return found == from.end() || found->second.size() != 1 ? kNoTwin : found->second.front();
  };
  std::vector<Triangle> missing;
  for (const auto& [origin, edges] : from) {
    if (edges.size() != 1) continue;
    const uint32_t a = edges.front(), b = next(a), c = b == kNoTwin ? kNoTwin : next(b);
    if (c == kNoTwin || next(c) != a || (FaceOf(a) == FaceOf(b) && FaceOf(b) == FaceOf(c)))
      continue;
    const uint32_t second = OriginOf(mesh.triangles, b), third = OriginOf(mesh.triangles, c);
    if (origin < second && origin < third) missing.push_back({origin, third, second});
  }
  return missing;
}

/// Disjoint sets of faces. Source: Galler and Fischer 1964, with path halving; a root is the face
/// with the smallest index in its set.
class FaceSets {
 public:
  explicit FaceSets(size_t faces) : parent_(faces), count_(static_cast<int64_t>(faces)) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void Join(uint32_t a, uint32_t b) {
    a = Root(a), b = Root(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }

  int64_t count() const { return count_; }

 private:
  uint32_t Root(uint32_t face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }

  std::vector<uint32_t> parent_;
  int64_t count_;
};

int64_t CountBodies(const EdgeTable& table) {
  FaceSets sets(table.twins.size() / 3);
  for (uint32_t h = 0; h < table.twins.size(); ++h)
    if (table.twins[h] < h) sets.Join(FaceOf(h), FaceOf(table.twins[h]));
  for (int64_t fan = 0; fan < table.fan_count(); ++fan)
    for (uint32_t i = table.fan_starts[fan] + 1; i < table.fan_starts[fan + 1]; ++i)
      sets.Join(FaceOf(table.fans[i - 1]), FaceOf(table.fans[i]));
  return sets.count();
}

}  // namespace

absl::StatusOr<ConnectedMesh> Connect(IndexedMesh mesh, const CancelToken& cancel) {
  ConnectedMesh connected;
  connected.triangles = static_cast<int64_t>(mesh.triangles.size());
  connected.degenerate_faces = DropCollapsedFaces(mesh.triangles);
  if (mesh.triangles.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "all triangles of the mesh are degenerate; check the units");
  if (cancel.Cancelled()) return cancel.Check();
  EdgeTable table = EdgesOfDistinct(mesh, connected.repeated_faces);
  if (cancel.Cancelled()) return cancel.Check();
  connected.degenerate_faces +=
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                    [&](const Triangle& t) { return HasNoArea(mesh, t); });
  connected.open_edges = table.open_edges;
  if (const std::vector<Triangle> missing = MissingFaces(mesh, table); !missing.empty()) {
    mesh.triangles.insert(mesh.triangles.end(), missing.begin(), missing.end());
    table = BuildEdgeTable(mesh.triangles, mesh.vertices.size());
  }
  connected.non_manifold_edges = table.fan_count();
  connected.bodies = CountBodies(table);
  connected.flipped_faces = OrientFaces(mesh, table);
  PairFans(mesh, table);
  connected.twins = std::move(table.twins);
  connected.closed =
      std::find(connected.twins.begin(), connected.twins.end(), kNoTwin) == connected.twins.end();
  connected.mesh = std::move(mesh);
  return connected;
}

EdgeCounts CountEdges(std::vector<Triangle> triangles, size_t vertex_count) {
  DropCollapsedFaces(triangles);
  const EdgeTable table = BuildEdgeTable(triangles, vertex_count);
  return {table.open_edges, table.fan_count()};
}

MeshReport ReportOf(const ConnectedMesh& mesh, Point shift) {
  MeshReport report;
  report.triangles = mesh.triangles;
  report.vertices = static_cast<int64_t>(mesh.mesh.vertices.size());
  report.bodies = mesh.bodies;
  report.open_edges = mesh.open_edges;
  report.non_manifold_edges = mesh.non_manifold_edges;
  report.flipped_faces = mesh.flipped_faces;
  report.degenerate_faces = mesh.degenerate_faces;
  report.repeated_faces = mesh.repeated_faces;
  report.volume_mm3 = VolumeMm3(mesh.mesh);
  const auto [min, max] = ExtentOf(mesh.mesh);
  const auto mm = [](Coord nm) { return ToMm(static_cast<double>(nm)); };
  report.min_mm = {mm(min.x + shift.x), mm(min.y + shift.y), mm(min.z)};
  report.max_mm = {mm(max.x + shift.x), mm(max.y + shift.y), mm(max.z)};
  return report;
}

}  // namespace slicefarm::slicing
