#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Returns true if `bytes` start like a PLY file.
bool LooksLikePly(std::string_view bytes);

/// Reads a Stanford PLY file, ASCII or binary in either byte order. It uses the properties `x`, `y`
/// and `z` of the element `vertex` and the list `vertex_indices` (or `vertex_index`) of the element
/// `face`. All other elements and properties are skipped. A face of n corners becomes a fan of n -
/// 2 triangles around its first corner.
///
/// Source: G. Turk, The PLY Polygon File Format, 1994. Arguments and errors: see ReadMesh.
absl::StatusOr<RawMesh> ReadPly(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel);

}  // namespace slicefarm::slicing
