#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"
#include "services/slicing/algo/topology/topology.h"

namespace slicefarm::slicing {

/// Returns a REQUEST_MALFORMED error with this message.
absl::Status Malformed(std::string_view message);

/// Reader of the meshes of a job's files. Reads a file when the mesh of one of its parts is first
/// requested, and frees the file's meshes after the last one is taken.
class PartMeshes {
 public:
  /// `objects`: the objects of the job. Take must be called once for each of their parts. `source`
  /// and `cancel` must outlive this object.
  PartMeshes(std::vector<MeshFile> files, const std::vector<ObjectInput>& objects,
             const MeshSource& source, const CancelToken& cancel,
             ReadDepth depth = ReadDepth::kMeshes);

  /// Returns the mesh of a part. Errors: any error of `source`; REQUEST_MALFORMED for a missing
  /// mesh, or if a project is used as a single mesh; MESH_TOO_LARGE if all meshes returned so far
  /// have more triangles than a job may have.
  absl::StatusOr<RawMesh> Take(const MeshRef& ref);

 private:
  bool Has(const MeshRef& ref) const { return 0 <= ref.file && ref.file < std::ssize(files_); }

  std::vector<MeshFile> files_;
  std::vector<std::optional<std::vector<RawMesh>>> meshes_;
  std::vector<int> uses_;  ///< number of remaining uses of each file
  int64_t taken_ = 0;      ///< number of triangles returned by Take
  const MeshSource& source_;
  const CancelToken& cancel_;
  const ReadDepth depth_;
};

/// Mesh of a part in nm. If rounding to nm merges corners, it also has the edge counts of the
/// file's mesh before rounding.
struct PlacedPart {
  IndexedMesh mesh;
  std::optional<EdgeCounts> edges_of_file;
  int64_t vertices_of_file = 0;
};

/// Object in nm around its own origin, without the positions of its copies.
struct PlacedObject {
  std::vector<PlacedPart> parts;
  Vertex to_origin;   ///< translation that moved all vertices to the object's origin
  Coord top_nm = 0;   ///< top of the solid parts
  Polygon footprint;  ///< convex hull of the solid parts
};

/// Places the parts of an object around the object's origin. Errors: any error of PartMeshes::Take
/// and TransformMesh; OUT_OF_RANGE.
absl::StatusOr<PlacedObject> PlaceParts(const ObjectInput& input, PartMeshes& meshes);

}  // namespace slicefarm::slicing
