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

/// What the service and a reader process say to each other: a request file (this head, then the
/// bytes of the mesh) is the reader's stdin, and its answer (a head, then what it announces) comes
/// from its stdout. Both are programs of one build on one machine, so structs travel as they are.
struct RequestHead {
  Confinement confinement = Confinement::kStrict;
  MeshFormat format = MeshFormat::kUnknown;
  ReadDepth depth = ReadDepth::kMeshes;
  double coordinate_limit = 0;
  ReaderLimits limits;
  int64_t service_pid = 0;
};

enum class AnswerKind : uint32_t {
  kContents,     ///< `project_bytes` of an encoded project, then `meshes` times a mesh
  kError,        ///< of reading: `error_bytes` of an encoded error
  kNotConfined,  ///< `error_bytes` of a text that says why; the mesh was not looked at
};

using BuildIdBytes = std::array<char, 16>;
BuildIdBytes ThisBuild();

struct AnswerHead {
  BuildIdBytes build_id = {};
  AnswerKind kind = AnswerKind::kContents;
  uint32_t error_bytes = 0;
  uint64_t project_bytes = 0;
  uint64_t meshes = 0;
};

/// Before each mesh: its positions and its triangles follow.
struct MeshHead {
  uint64_t positions = 0;
  uint64_t triangles = 0;
};

/// The exit code of a reader that got no more memory.
inline constexpr int kNoMemoryExit = 3;

std::string EncodeError(const absl::Status& error);

// The rest takes nothing for granted: a reader that a mesh has taken over may answer anything.

/// What a request was about, which bounds what may be answered: the numbers that are announced
/// decide how much memory the service takes.
struct Request {
  /// The most bytes of text that the file can stand for: of an archive, what it may expand to.
  int64_t text_bytes = 0;
  ReadDepth depth = ReadDepth::kMeshes;
};

Request RequestOf(std::string_view file, ReadDepth depth);

/// Errors: BUILD_MISMATCH; MESH_READER_CRASHED for numbers that no reader would send.
absl::Status CheckHead(const AnswerHead& head, const Request& request);

/// Bounds what all meshes of an answer have together. Errors: MESH_READER_CRASHED.
class MeshHeads {
 public:
  explicit MeshHeads(const Request& request);
  absl::Status Check(const MeshHead& head);

 private:
  uint64_t triangles_left_;
  uint64_t positions_left_;
};

/// The error of an encoded one: always InvalidArgument, with one of the reasons of ReadMesh; what
/// else it may say is MESH_READER_CRASHED.
absl::Status DecodeError(std::string_view encoded);

/// Whether the mesh is what RawMesh promises: valid indices, finite coordinates within the limit.
/// Errors: MESH_READER_CRASHED. Cost: one pass.
absl::Status CheckMesh(const RawMesh& mesh, double coordinate_limit);

/// The project of an answer, whose meshes (if they were asked for) are there already.
/// Errors: MESH_READER_CRASHED.
absl::StatusOr<Project> CheckedProject(std::string_view encoded, std::span<const RawMesh> meshes,
                                       ReadDepth depth);

/// InvalidArgument, MESH_READER_CRASHED: the mesh is at fault, and trying again is of no use.
absl::Status ReaderCrashed(std::string_view how, std::map<std::string, std::string> metadata = {});

}  // namespace slicefarm::slicing
