#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Detects the format of `bytes`.
///
/// - Binary STL if the length matches the count of triangles, regardless of the header.
/// - ASCII STL if the text starts with `solid` and has a facet or an end.
/// - PLY and 3MF (any ZIP archive) by their first bytes.
/// - OBJ if the first statement is an OBJ statement.
/// - Otherwise a binary STL of the wrong length, unless the bytes start like another known format.
MeshFormat DetectFormat(std::string_view bytes);

/// Reads a file of a format that has one mesh (STL, OBJ, PLY), and welds corners at exactly the
/// same position.
///
/// `format`: the declared format of the file; kUnknown: detected from the content.
/// `coordinate_limit`: the largest accepted absolute coordinate, in the units of the file. Errors:
/// InvalidArgument with reason
///   MESH_FORMAT_UNKNOWN  not a format of MeshFormat
///   MESH_TRUNCATED       less data than the header claims, or no end
///   MESH_MALFORMED       violation of the format; metadata names the line or the triangle
///   MESH_NOT_FINITE      NaN or infinity
///   OUT_OF_RANGE         a coordinate beyond the limit
///   MESH_TOO_LARGE       more bytes or triangles than limits.h allows: metadata `limit`, `got`
///   MESH_EMPTY           no triangle
/// and Cancelled. Cost: one pass over the bytes, O(1) per triangle; memory for the result only.
absl::StatusOr<RawMesh> ReadMesh(std::string_view bytes, MeshFormat format, double coordinate_limit,
                                 const CancelToken& cancel);

/// Reads a file of any supported format. A format with one mesh gives a project of one object
/// without a position. Each mesh is welded separately.
///
/// `depth`: with kStructure, the function reads the same bytes and returns the same errors, but
/// returns no meshes. Errors: any error of ReadMesh; for a 3MF, metadata `part` names the file in
/// the archive, and `line` the line in that file. Cost: as ReadMesh; a 3MF needs memory for one
/// piece of text in addition.
absl::StatusOr<MeshFileContents> ReadMeshFile(std::string_view bytes, MeshFormat format,
                                              double coordinate_limit, ReadDepth depth,
                                              const CancelToken& cancel);

}  // namespace slicefarm::slicing
