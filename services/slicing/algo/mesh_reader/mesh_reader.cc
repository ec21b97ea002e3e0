#include "services/slicing/algo/mesh_reader/mesh_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/obj_reader.h"
#include "services/slicing/algo/mesh_io/ply_reader.h"
#include "services/slicing/algo/mesh_io/stl_reader.h"
#include "services/slicing/algo/mesh_io/threemf/threemf_reader.h"

namespace slicefarm::slicing {
namespace {

constexpr std::string_view kStepMark = "ISO-10303-21";

/// First bytes of formats that users may mistake for supported meshes.
constexpr std::array<std::string_view, 7> kForeignMarks = {"<?xml", "glTF",     "\x89PNG", "%PDF",
                                                           "OFF",   "\x1f\x8b", kStepMark};

bool IsForeign(std::string_view bytes) {
  return std::any_of(kForeignMarks.begin(), kForeignMarks.end(),
                     [&](std::string_view mark) { return bytes.starts_with(mark); });
}

/// First bytes of a Git LFS pointer. A repository has it in place of a large file that was not
/// fetched.
constexpr std::string_view kLfsMark = "version https://git-lfs.github.com/";

absl::Status UnknownFormat(std::string_view bytes) {
  std::string_view what =
      "the file is not STL, OBJ, PLY or 3MF; export the part in one of these formats";
  if (bytes.starts_with(kLfsMark))
    what = "the file is a Git LFS pointer, not a model; fetch the model with git lfs pull";
  if (bytes.starts_with(kStepMark))
    what = "the file is STEP, which has no triangles; export the part as STL or 3MF";
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshFormatUnknown,
                   std::string(what));
}

absl::StatusOr<RawMesh> ReadStl(std::string_view bytes, double coordinate_limit,
                                const CancelToken& cancel) {
  if (!IsBinaryStl(bytes) && LooksLikeAsciiStl(bytes))
    return ReadAsciiStl(bytes, coordinate_limit, cancel);
  return ReadBinaryStl(bytes, coordinate_limit, cancel);
}

/// Reads a file of a format that has one mesh.
absl::StatusOr<RawMesh> ReadOneMesh(std::string_view bytes, MeshFormat format,
                                    double coordinate_limit, const CancelToken& cancel) {
  switch (format) {
    case MeshFormat::kStl:
      return ReadStl(bytes, coordinate_limit, cancel);
    case MeshFormat::kObj:
      return ReadObj(bytes, coordinate_limit, cancel);
    case MeshFormat::kPly:
      return ReadPly(bytes, coordinate_limit, cancel);
    case MeshFormat::k3mf:
    case MeshFormat::kUnknown:
      break;
  }
  return UnknownFormat(bytes);
}

absl::StatusOr<RawMesh> NotEmpty(absl::StatusOr<RawMesh> mesh) {
  if (!mesh.ok() || !mesh->triangles.empty()) return mesh;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                   "the file has no triangles");
}

/// Returns a project of one object with the file's only mesh and without a position.
Project ProjectOfOneMesh() {
  Instance instance;
  instance.placed = false;
  SceneObject object;
  object.parts.emplace_back();
  object.instances.push_back(instance);
  Project project;
  project.objects.push_back(std::move(object));
  return project;
}

absl::Status CheckSize(std::string_view bytes) {
  if (bytes.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty, "the file is empty");
  if (static_cast<int64_t>(bytes.size()) > limits::kMaxMeshBytes)
    return LimitError(Reason::kMeshTooLarge, "bytes of the mesh file", limits::kMaxMeshBytes,
                      static_cast<int64_t>(bytes.size()));
  return absl::OkStatus();
}

}  // namespace

MeshFormat DetectFormat(std::string_view bytes) {
  constexpr size_t kSmallestBinaryStl = 84;
  if (IsBinaryStl(bytes) || LooksLikeAsciiStl(bytes)) return MeshFormat::kStl;
  if (LooksLikePly(bytes)) return MeshFormat::kPly;
  if (LooksLike3mf(bytes)) return MeshFormat::k3mf;
  if (LooksLikeObj(bytes)) return MeshFormat::kObj;
  if (bytes.size() < kSmallestBinaryStl || bytes.starts_with(kLfsMark) || IsForeign(bytes))
    return MeshFormat::kUnknown;
  return MeshFormat::kStl;
}

absl::StatusOr<RawMesh> ReadMesh(std::string_view bytes, MeshFormat format, double coordinate_limit,
                                 const CancelToken& cancel) {
  if (absl::Status status = CheckSize(bytes); !status.ok()) return status;
  if (format == MeshFormat::kUnknown) format = DetectFormat(bytes);
  return NotEmpty(ReadOneMesh(bytes, format, coordinate_limit, cancel));
}

absl::StatusOr<MeshFileContents> ReadMeshFile(std::string_view bytes, MeshFormat format,
                                              double coordinate_limit, ReadDepth depth,
                                              const CancelToken& cancel) {
  if (absl::Status status = CheckSize(bytes); !status.ok()) return status;
  if (format == MeshFormat::kUnknown) format = DetectFormat(bytes);
  if (format == MeshFormat::k3mf) return Read3mf(bytes, coordinate_limit, depth, cancel);
  const bool numbered = depth == ReadDepth::kNumbered && format == MeshFormat::kObj;
  absl::StatusOr<RawMesh> mesh = numbered
                                     ? NotEmpty(ReadObjAsNumbered(bytes, coordinate_limit, cancel))
                                     : ReadMesh(bytes, format, coordinate_limit, cancel);
  if (!mesh.ok()) return mesh.status();
  MeshFileContents contents;
  contents.project = ProjectOfOneMesh();
  if (depth != ReadDepth::kStructure) contents.meshes.push_back(*std::move(mesh));
  return contents;
}

}  // namespace slicefarm::slicing
