#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Whether the first statement of `bytes` is one of OBJ's.
bool LooksLikeObj(std::string_view bytes);

/// Wavefront OBJ: `v` and `f`; other statements are passed over, no file that they name is ever
/// opened. A face of n corners becomes a fan of n - 2 triangles around its first corner. Indices
/// count from 1, negative ones back from the last vertex so far; an index may refer to a vertex
/// further down. Source: Wavefront, Advanced Visualizer manual, appendix B1. Arguments and errors:
/// see ReadMesh.
absl::StatusOr<RawMesh> ReadObj(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel);

/// The same with the file's own vertices, by their numbers: those at one place stay apart, those
/// that no face uses stay.
absl::StatusOr<RawMesh> ReadObjAsNumbered(std::string_view bytes, double coordinate_limit,
                                          const CancelToken& cancel);

}  // namespace slicefarm::slicing
