#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Mesh with the neighbours of its faces. These repairs are already made:
/// - Faces with two equal corners and repeated faces are removed.
/// - Faces that were oriented against their body are flipped.
/// - If three open edges of several faces form a triangle, the missing face is inserted.
///
/// A face with three corners on one line is kept: it has no area, but it connects its neighbours.
struct ConnectedMesh {
  IndexedMesh mesh;
  /// Twin of each half-edge: the half-edge of the neighbouring face, in the opposite direction.
  /// kNoTwin where the surface ends.
  std::vector<uint32_t> twins;
  /// true if every half-edge has a twin, so that every section consists of closed loops
  bool closed = false;

  // Counts of the file's mesh, for the report:
  int64_t triangles = 0;
  int64_t degenerate_faces = 0;
  /// number of faces with the same corners and orientation as an earlier face
  int64_t repeated_faces = 0;
  int64_t flipped_faces = 0;
  // Counts after degenerate and repeated faces are removed, and before missing faces are inserted:
  int64_t open_edges = 0;
  int64_t non_manifold_edges = 0;
  /// Number of bodies. A body is connected over edges; two bodies may share a vertex.
  int64_t bodies = 0;
};

/// Connects the faces of a mesh. Errors: Cancelled; MESH_EMPTY if all faces are degenerate. Cost:
/// O(n) and a sort at each non-manifold edge.
absl::StatusOr<ConnectedMesh> Connect(IndexedMesh mesh, const CancelToken& cancel);

/// Numbers of open and non-manifold edges.
struct EdgeCounts {
  int64_t open = 0;          ///< edges with one face
  int64_t non_manifold = 0;  ///< edges with more than two faces
};

/// Returns the numbers of open and non-manifold edges. Faces with two equal corners are ignored.
/// Cost: as BuildEdgeTable.
EdgeCounts CountEdges(std::vector<Triangle> triangles, size_t vertex_count);

/// Returns the report of a mesh before slicing; fields for results of slicing are not set. `shift`
/// moves the reported bounding box to the position of the first copy.
MeshReport ReportOf(const ConnectedMesh& mesh, Point shift);

}  // namespace slicefarm::slicing
