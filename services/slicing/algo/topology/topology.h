#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// A mesh whose faces know their neighbours. Faces with two equal corners are gone, and so are those
/// that are there twice; faces that ran against their body are turned. Where three open edges of several faces make a
/// triangle, the face that is missing there is put in. A face with three corners on one line stays: it has no area, but
/// it joins its neighbours.
struct ConnectedMesh {
  IndexedMesh mesh;
  /// The half-edge across, which runs the other way; kNoTwin where the surface ends.
  std::vector<uint32_t> twins;
  bool closed = false;  ///< every half-edge has a twin: every section is made of closed loops

  // As the file had it, for the report:
  int64_t triangles = 0;
  int64_t degenerate_faces = 0;
  int64_t repeated_faces = 0;  ///< with the corners of another one, in the same sense
  int64_t flipped_faces = 0;
  // Once those are gone, and before missing faces are put in:
  int64_t open_edges = 0;
  int64_t non_manifold_edges = 0;
  int64_t bodies = 0;  ///< connected over edges; parts that meet in a vertex only count apart
};

/// Errors: Cancelled; MESH_EMPTY if all faces are degenerate. Cost: O(n) and a sort at each
/// non-manifold edge.
absl::StatusOr<ConnectedMesh> Connect(IndexedMesh mesh, const CancelToken& cancel);

struct EdgeCounts {
  int64_t open = 0;          ///< with one face
  int64_t non_manifold = 0;  ///< with more than two faces
};

/// Counts edges without connecting anything. Faces with two equal corners are passed over. Cost: as
/// BuildEdgeTable.
EdgeCounts CountEdges(std::vector<Triangle> triangles, size_t vertex_count);

/// What the report says of a mesh before it is sliced; `shift` moves the box to where the first
/// copy stands.
MeshReport ReportOf(const ConnectedMesh& mesh, Point shift);

}  // namespace slicefarm::slicing
