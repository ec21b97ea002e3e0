#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Returns true if the first statement of `bytes` is an OBJ statement.
bool LooksLikeObj(std::string_view bytes);

/// Reads a Wavefront OBJ file: the statements `v` and `f`. Other statements are skipped, and other
/// files that they name are never opened.
///
/// A face of n corners becomes a fan of n - 2 triangles around its first corner. Positive indices
/// count from 1. Negative indices count back from the last vertex so far. An index may refer to a
/// vertex that follows later in the file.
///
/// Source: Wavefront, Advanced Visualizer manual, appendix B1. Arguments and errors: see ReadMesh.
absl::StatusOr<RawMesh> ReadObj(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel);

/// Reads an OBJ file like ReadObj, but keeps the vertices of the file with their numbers. Vertices
/// at the same position are not merged, and unused vertices are kept.
absl::StatusOr<RawMesh> ReadObjAsNumbered(std::string_view bytes, double coordinate_limit,
                                          const CancelToken& cancel);

}  // namespace slicefarm::slicing
