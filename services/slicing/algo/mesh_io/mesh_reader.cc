#include "services/slicing/algo/mesh_io/mesh_reader.h"

#include <algorithm>
#include <array>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/obj_reader.h"
#include "services/slicing/algo/mesh_io/stl_reader.h"

namespace slicefarm::slicing {
namespace {

/// How files begin that people take for meshes we can read.
constexpr std::array<std::string_view, 9> kForeignMarks = {
    "PK\x03\x04", "<?xml", "glTF", "ply", "\x89PNG", "%PDF", "OFF", "\x1f\x8b", "ISO-10303-21"};

bool IsForeign(std::string_view bytes) {
  return std::any_of(kForeignMarks.begin(), kForeignMarks.end(),
                     [&](std::string_view mark) { return bytes.starts_with(mark); });
}

absl::StatusOr<RawMesh> ReadStl(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel) {
  if (!IsBinaryStl(bytes) && LooksLikeAsciiStl(bytes))
    return ReadAsciiStl(bytes, coordinate_limit, cancel);
  return ReadBinaryStl(bytes, coordinate_limit, cancel);
}

}  // namespace

MeshFormat DetectFormat(std::string_view bytes) {
  constexpr size_t kSmallestBinaryStl = 84;
  if (IsBinaryStl(bytes) || LooksLikeAsciiStl(bytes)) return MeshFormat::kStl;
  if (LooksLikeObj(bytes)) return MeshFormat::kObj;
  if (bytes.size() < kSmallestBinaryStl || IsForeign(bytes)) return MeshFormat::kUnknown;
  return MeshFormat::kStl;
}

absl::StatusOr<RawMesh> ReadMesh(std::string_view bytes, MeshFormat format, double coordinate_limit,
                                 const CancelToken& cancel) {
  if (bytes.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty, "the file is empty");
  if (static_cast<int64_t>(bytes.size()) > limits::kMaxMeshBytes)
    return LimitError(Reason::kMeshTooLarge, "bytes of the mesh file", limits::kMaxMeshBytes,
                      static_cast<int64_t>(bytes.size()));
  if (format == MeshFormat::kUnknown) format = DetectFormat(bytes);
  if (format == MeshFormat::kUnknown)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshFormatUnknown,
                     "neither STL nor OBJ; export the part in one of these formats");
  absl::StatusOr<RawMesh> mesh = format == MeshFormat::kObj
                                     ? ReadObj(bytes, coordinate_limit, cancel)
                                     : ReadStl(bytes, coordinate_limit, cancel);
  if (mesh.ok() && mesh->triangles.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "the file has no triangles");
  return mesh;
}

}  // namespace slicefarm::slicing
