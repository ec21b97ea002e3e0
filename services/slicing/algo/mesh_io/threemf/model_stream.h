#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"
#include "services/slicing/algo/mesh_io/threemf/model_file.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive.h"

namespace slicefarm::slicing::threemf {

/// Reads a model file while it is decompressed, piece by piece. An XML parser reads its structure;
/// a scanner reads the sequences of vertices and triangles. The result does not depend on the
/// boundaries of the pieces.
///
/// `meshes` receives the meshes, in the order of the file. Errors: any error of Archive, XmlParser
/// and ModelHandler; Cancelled. Cost: one pass; memory for the meshes and one piece of text.
absl::StatusOr<ModelFile> ReadModelFile(const Archive& archive, const ArchiveEntry& entry,
                                        MeshReading& reading, std::vector<RawMesh>& meshes,
                                        const CancelToken& cancel);

}  // namespace slicefarm::slicing::threemf
