#include "services/slicing/sandbox/sandboxed_mesh_source.h"

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/sandbox/reader_process.h"
#include "services/slicing/sandbox/reader_protocol.h"
#include "services/slicing/sandbox/request_file.h"

namespace slicefarm::slicing {
namespace {

absl::Status TooExpensive(std::string_view resource, int64_t limit) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshTooExpensive,
                   fmt::format("reading this mesh takes more than {} {}", limit, resource),
                   {{"resource", std::string(resource)}, {"limit", std::to_string(limit)}});
}

absl::Status KilledFromOutside() {
  return MakeError(
      absl::StatusCode::kUnavailable, Reason::kMeshReaderKilled,
      "the process that read this mesh was killed from outside, probably because memory ran out");
}

/// Returns the reason why a reader ended without a complete answer.
absl::Status ErrorOf(const ProcessEnd& end, const ReaderLimits& limits) {
  if (WIFEXITED(end.wait_status)) {
    const int code = WEXITSTATUS(end.wait_status);
    if (code == kNoMemoryExit) return TooExpensive("memory_bytes", limits.memory_bytes);
    return ReaderCrashed(fmt::format("ended without an answer, exit code {}", code),
                         {{"exit_code", std::to_string(code)}});
  }
  const int signal = WTERMSIG(end.wait_status);
  const bool time_was_up = end.cpu_s >= static_cast<double>(limits.cpu_s);
  if (signal == SIGXCPU || (signal == SIGKILL && time_was_up))
    return TooExpensive("cpu_s", limits.cpu_s);
  if (signal == SIGKILL) return KilledFromOutside();
  return ReaderCrashed(fmt::format("was ended by signal {} ({})", signal, sigdescr_np(signal)),
                       {{"signal", std::to_string(signal)}});
}

absl::Status NotConfined(std::string_view why) {
  return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kInternal,
                   fmt::format("a mesh reader cannot be confined: {}", why));
}

template <typename T>
std::span<char> BytesOf(std::vector<T>& values) {
  return {reinterpret_cast<char*>(values.data()), values.size() * sizeof(T)};
}

/// Reading of one mesh by a reader program.
class Reading {
 public:
  Reading(ReaderProcess reader, const ReaderLimits& limits, const CancelToken& cancel)
      : reader_(std::move(reader)), limits_(limits), cancel_(cancel) {}

  absl::StatusOr<MeshFileContents> Answer(const Request& request, double coordinate_limit) {
    AnswerHead head;
    absl::Status status = Receive({reinterpret_cast<char*>(&head), sizeof head});
    if (status.ok()) status = CheckHead(head, request);
    if (!status.ok()) return status;
    if (head.kind != AnswerKind::kContents) return Error(head);
    return Contents(head, request, coordinate_limit);
  }

 private:
  absl::Status Receive(std::span<char> bytes) {
    const absl::StatusOr<bool> whole = reader_.Receive(bytes, cancel_);
    if (!whole.ok()) return whole.status();
    if (*whole) return absl::OkStatus();
    const absl::StatusOr<ProcessEnd> end = reader_.AwaitEnd(cancel_);
    return end.ok() ? ErrorOf(*end, limits_) : end.status();
  }

  absl::Status Error(const AnswerHead& head) {
    std::string text(head.error_bytes, '\0');
    if (absl::Status status = Receive(text); !status.ok()) return status;
    return head.kind == AnswerKind::kError ? DecodeError(text) : NotConfined(text);
  }

  absl::StatusOr<MeshFileContents> Contents(const AnswerHead& head, const Request& request,
                                            double coordinate_limit) {
    std::string encoded(head.project_bytes, '\0');
    if (absl::Status status = Receive(encoded); !status.ok()) return status;
    MeshFileContents contents;
    MeshHeads heads(request);
    for (uint64_t i = 0; i < head.meshes; ++i) {
      absl::StatusOr<RawMesh> mesh = Mesh(heads, coordinate_limit);
      if (!mesh.ok()) return mesh.status();
      contents.meshes.push_back(*std::move(mesh));
    }
    absl::StatusOr<Project> project = CheckedProject(encoded, contents.meshes, request.depth);
    if (!project.ok()) return project.status();
    contents.project = *std::move(project);
    return contents;
  }

  absl::StatusOr<RawMesh> Mesh(MeshHeads& heads, double coordinate_limit) {
    MeshHead head;
    absl::Status status = Receive({reinterpret_cast<char*>(&head), sizeof head});
    if (status.ok()) status = heads.Check(head);
    if (!status.ok()) return status;
    RawMesh mesh;
    mesh.positions.resize(head.positions);
    status = Receive(BytesOf(mesh.positions));
    if (!status.ok()) return status;
    mesh.triangles.resize(head.triangles);
    status = Receive(BytesOf(mesh.triangles));
    if (status.ok()) status = CheckMesh(mesh, coordinate_limit);
    if (!status.ok()) return status;
    return mesh;
  }

  ReaderProcess reader_;
  const ReaderLimits limits_;
  const CancelToken& cancel_;
};

}  // namespace

absl::Status SandboxedMeshSource::Probe() const {
  constexpr char kTriangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  return Read(kTriangle, MeshFormat::kObj, 1, ReadDepth::kMeshes, {}).status();
}

absl::StatusOr<MeshFileContents> SandboxedMeshSource::Read(std::string bytes, MeshFormat format,
                                                           double coordinate_limit, ReadDepth depth,
                                                           const CancelToken& cancel) const {
  const Request asked = RequestOf(bytes, depth);
  ReaderLimits limits = options_.limits(bytes);
  std::optional<ByteBudget::Share> share;
  if (options_.memory != nullptr) {
    limits.memory_bytes = std::min(limits.memory_bytes, options_.memory->limit());
    auto taken = options_.memory->Take(limits.memory_bytes, cancel);
    if (!taken.ok()) return taken.status();
    share.emplace(*std::move(taken));
  }
  const RequestHead head = {.confinement = options_.confinement,
                            .format = format,
                            .depth = depth,
                            .coordinate_limit = coordinate_limit,
                            .limits = limits,
                            .service_pid = getpid()};
  absl::StatusOr<Fd> request = MakeRequestFile(head, bytes, cancel);
  if (!request.ok()) return request.status();
  bytes = std::string();
  absl::StatusOr<ReaderProcess> reader = ReaderProcess::Start(options_.program, *request);
  if (!reader.ok()) return reader.status();
  *request = Fd();  // the reader holds it; it ends with the reader
  return Reading(*std::move(reader), limits, cancel).Answer(asked, coordinate_limit);
}

}  // namespace slicefarm::slicing
