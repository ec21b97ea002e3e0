#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"
#include "services/slicing/sandbox/confinement.h"

namespace slicefarm::slicing {

/// Head of a request. The protocol between the service and a reader program: the reader's stdin is
/// a request file, which contains this head and the bytes of the mesh. The reader's answer on
/// stdout is a head, then the contents that the head announces. Both programs are of one build and
/// on one machine, so structs are sent as bytes of memory.
struct RequestHead {
  Confinement confinement = Confinement::kStrict;
  MeshFormat format = MeshFormat::kUnknown;
  ReadDepth depth = ReadDepth::kMeshes;
  double coordinate_limit = 0;
  ReaderLimits limits;
  int64_t service_pid = 0;
};

/// Kind of an answer: the contents after its head. The named numbers are members of AnswerHead.
enum class AnswerKind : uint32_t {
  kContents,  ///< an encoded project of `project_bytes` bytes, then `meshes` meshes
  kError,     ///< the mesh could not be read: an encoded error of `error_bytes` bytes
  /// the mesh was not read, because the reader is not confined: a text of `error_bytes` bytes with
  /// the reason
  kNotConfined,
};

/// Id of a build.
using BuildIdBytes = std::array<char, 16>;
/// Returns the id of this build.
BuildIdBytes ThisBuild();

/// First part of an answer.
struct AnswerHead {
  BuildIdBytes build_id = {};
  AnswerKind kind = AnswerKind::kContents;
  uint32_t error_bytes = 0;
  uint64_t project_bytes = 0;
  uint64_t meshes = 0;
};

/// Head of each mesh; its positions and its triangles follow.
struct MeshHead {
  uint64_t positions = 0;
  uint64_t triangles = 0;
};

/// Exit code of a reader for which the system had no more memory.
inline constexpr int kNoMemoryExit = 3;

/// Returns an error (reason, message and metadata) as text for an answer.
std::string EncodeError(const absl::Status& error);

// The following functions trust no answer: a hostile mesh file may have taken control of the
// reader.

/// Properties of a request from which the service derives upper limits of the answer. It allocates
/// memory by the numbers in the answer's head, so these numbers must have limits.
struct Request {
  /// Largest number of text bytes that the file can represent; for an archive, its largest expanded
  /// size.
  int64_t text_bytes = 0;
  ReadDepth depth = ReadDepth::kMeshes;
};

/// Returns the properties of a request.
Request RequestOf(std::string_view file, ReadDepth depth);

/// Checks the head of an answer. Errors: BUILD_MISMATCH; MESH_READER_CRASHED for numbers that no
/// correct reader would send.
absl::Status CheckHead(const AnswerHead& head, const Request& request);

/// Check of the heads of an answer's meshes: their totals must not exceed the totals in AnswerHead.
/// Errors: MESH_READER_CRASHED.
class MeshHeads {
 public:
  explicit MeshHeads(const Request& request);
  /// Checks that the counts in the head of the next mesh do not exceed the remaining totals.
  /// Subtracts the counts from these totals.
  absl::Status Check(const MeshHead& head);

 private:
  uint64_t triangles_left_;
  uint64_t positions_left_;
};

/// Decodes an error. The result is always InvalidArgument with one of the reasons of ReadMesh;
/// anything else gives MESH_READER_CRASHED.
absl::Status DecodeError(std::string_view encoded);

/// Checks that the mesh fulfils RawMesh: valid indices, finite coordinates within the limit.
/// Errors: MESH_READER_CRASHED. Cost: one pass.
absl::Status CheckMesh(const RawMesh& mesh, double coordinate_limit);

/// Returns the decoded project of an answer. Checks it against the meshes, which must be read
/// before if they were requested. Errors: MESH_READER_CRASHED.
absl::StatusOr<Project> CheckedProject(std::string_view encoded, std::span<const RawMesh> meshes,
                                       ReadDepth depth);

/// Returns InvalidArgument with MESH_READER_CRASHED: the mesh is the cause, so a retry is useless.
absl::Status ReaderCrashed(std::string_view how, std::map<std::string, std::string> metadata = {});

}  // namespace slicefarm::slicing
