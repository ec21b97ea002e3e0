#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Whether `bytes` start like a PLY.
bool LooksLikePly(std::string_view bytes);

/// Stanford PLY, ASCII and binary of either byte order: the properties `x`, `y`, `z` of the element
/// `vertex`, and the list `vertex_indices` (or `vertex_index`) of the element `face`; all other
/// elements and properties are passed over. A face of n corners becomes a fan of n - 2 triangles
/// around its first corner. Source: G. Turk, The PLY Polygon File Format, 1994. Arguments and
/// errors: see ReadMesh.
absl::StatusOr<RawMesh> ReadPly(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel);

}  // namespace slicefarm::slicing
