#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// What `bytes` look like: binary STL if the length is the one its count of triangles asks for,
/// whatever the header says; ASCII STL if it starts with `solid` and has a facet or an end; PLY and
/// 3MF (any ZIP archive) by their first bytes; OBJ if its first statement is one of OBJ's; else a
/// binary STL of the wrong length, unless it bears the mark of some other format.
MeshFormat DetectFormat(std::string_view bytes);

/// Reads a file of any format that has one mesh (STL, OBJ, PLY), and welds corners at exactly the
/// same place.
///
/// `format`: what the file is said to be; kUnknown: told from the content.
/// `coordinate_limit`: the largest absolute coordinate accepted, in the units of the file.
/// Errors: InvalidArgument with reason
///   MESH_FORMAT_UNKNOWN  not a format of MeshFormat
///   MESH_TRUNCATED       less data than the header claims, or no end
///   MESH_MALFORMED       what does not follow the format; metadata names the line or the triangle
///   MESH_NOT_FINITE      NaN or infinity
///   OUT_OF_RANGE         a coordinate beyond the limit
///   MESH_TOO_LARGE       more bytes or triangles than limits.h allows (`limit`, `got`)
///   MESH_EMPTY           no triangle
/// and Cancelled. Cost: one pass over the bytes, O(1) a triangle; memory for the result only.
absl::StatusOr<RawMesh> ReadMesh(std::string_view bytes, MeshFormat format, double coordinate_limit,
                                 const CancelToken& cancel);

/// Reads a file of any format this service knows. What has no more than one mesh becomes a project
/// of one object that may stand anywhere. Each mesh is welded by itself.
///
/// `depth`: the structure alone is told from the same bytes and refused for the same errors.
/// Errors: those of ReadMesh, in which metadata `part` names the file in the archive of a 3MF, and
/// `line` the line of that. Cost: for 3MF, besides a mesh, a piece of text.
absl::StatusOr<MeshFileContents> ReadMeshFile(std::string_view bytes, MeshFormat format,
                                              double coordinate_limit, ReadDepth depth,
                                              const CancelToken& cancel);

}  // namespace slicefarm::slicing
