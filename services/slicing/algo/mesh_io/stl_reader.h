#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

// Readers of binary and ASCII STL files. Normals and attributes are ignored: the order of the
// corners defines the outside. Source: 3D Systems, StereoLithography Interface Specification,
// 1989. Arguments and errors: see ReadMesh.

/// Returns true if `bytes` have the length of a binary STL file: 84 + 50 n, where n is the number
/// of triangles stored at offset 80.
bool IsBinaryStl(std::string_view bytes);

/// Returns true if `bytes` start like an ASCII STL file.
bool LooksLikeAsciiStl(std::string_view bytes);

/// Reads a binary STL file.
absl::StatusOr<RawMesh> ReadBinaryStl(std::string_view bytes, double coordinate_limit,
                                      const CancelToken& cancel);

/// Reads an ASCII STL file. Keywords may be in upper or lower case. Text between the statements is
/// an error.
absl::StatusOr<RawMesh> ReadAsciiStl(std::string_view bytes, double coordinate_limit,
                                     const CancelToken& cancel);

}  // namespace slicefarm::slicing
