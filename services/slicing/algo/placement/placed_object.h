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

/// REQUEST_MALFORMED with these words.
absl::Status Malformed(std::string_view message);

/// The meshes of files, each file's freed after their last use.
class PartMeshes {
 public:
  /// `objects`: whose parts will be taken, each once. `source` and `cancel` must outlive this.
  PartMeshes(std::vector<MeshFile> files, const std::vector<ObjectInput>& objects,
             const MeshSource& source, const CancelToken& cancel,
             ReadDepth depth = ReadDepth::kMeshes);

  /// Errors: those of the source; REQUEST_MALFORMED for a mesh that is not there, and for a project
  /// that is taken for a single mesh; MESH_TOO_LARGE if all that was taken has more triangles than
  /// a job may have.
  absl::StatusOr<RawMesh> Take(const MeshRef& ref);

 private:
  bool Has(const MeshRef& ref) const { return 0 <= ref.file && ref.file < std::ssize(files_); }

  std::vector<MeshFile> files_;
  std::vector<std::optional<std::vector<RawMesh>>> meshes_;
  std::vector<int> uses_;  ///< to come, by file
  int64_t taken_ = 0;      ///< triangles
  const MeshSource& source_;
  const CancelToken& cancel_;
  const ReadDepth depth_;
};

/// A part's triangles in nm, and the edges as the file has them where rounding welds corners.
struct PlacedPart {
  IndexedMesh mesh;
  std::optional<EdgeCounts> edges_of_file;
  int64_t vertices_of_file = 0;
};

/// An object in nm around its own origin, before its copies have places.
struct PlacedObject {
  std::vector<PlacedPart> parts;
  Vertex to_origin;   ///< what was added to all vertices
  Coord top_nm = 0;   ///< of the solid ones
  Polygon footprint;  ///< convex hull of the solid ones
};

/// Errors: those of PartMeshes::Take and TransformMesh; OUT_OF_RANGE.
absl::StatusOr<PlacedObject> PlaceParts(const ObjectInput& input, PartMeshes& meshes);

}  // namespace slicefarm::slicing
