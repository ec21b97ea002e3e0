#include "services/slicing/sandbox/reader_side.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <new>
#include <string>

#include "services/slicing/algo/mesh_io/point_hash.h"
#include "services/slicing/sandbox/fd.h"
#include "services/slicing/sandbox/project_codec.h"
#include "services/slicing/sandbox/reader_protocol.h"

namespace slicefarm::slicing {
namespace {

constexpr int kNoRequestExit = 2;

/// Exits without an answer, because the service has ended or has sent an invalid request.
[[noreturn]] void EndUnheard() { _exit(kNoRequestExit); }

/// Asks the system to kill this reader rather than the service when memory runs out. If the system
/// does not permit this request, it chooses a program itself.
void StepForwardWhenMemoryRunsOut() {
  const Fd file(open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
  constexpr std::string_view kFirst = "1000";
  (void)!write(file.number(), kFirst.data(), kFirst.size());
}

std::string_view MapRequest() {
  struct stat file = {};
  if (fstat(STDIN_FILENO, &file) != 0 || file.st_size < static_cast<off_t>(sizeof(RequestHead)))
    EndUnheard();
  const auto size = static_cast<size_t>(file.st_size);
  void* begin = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, STDIN_FILENO, 0);
  if (begin == MAP_FAILED) EndUnheard();
  close(STDIN_FILENO);
  return {static_cast<const char*>(begin), size};
}

void Write(const void* data, size_t size) {
  for (const char* at = static_cast<const char*>(data); size > 0;) {
    const ssize_t written = write(STDOUT_FILENO, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) EndUnheard();
    at += written;
    size -= static_cast<size_t>(written);
  }
}

[[noreturn]] void AnswerError(AnswerKind kind, std::string_view text) {
  const AnswerHead head = {
      .build_id = ThisBuild(), .kind = kind, .error_bytes = static_cast<uint32_t>(text.size())};
  Write(&head, sizeof head);
  Write(text.data(), text.size());
  _exit(0);
}

[[noreturn]] void AnswerContents(const MeshFileContents& contents) {
  const std::string project = EncodeProject(contents.project);
  const AnswerHead head = {.build_id = ThisBuild(),
                           .kind = AnswerKind::kContents,
                           .project_bytes = project.size(),
                           .meshes = contents.meshes.size()};
  Write(&head, sizeof head);
  Write(project.data(), project.size());
  for (const RawMesh& mesh : contents.meshes) {
    const MeshHead mesh_head = {.positions = mesh.positions.size(),
                                .triangles = mesh.triangles.size()};
    Write(&mesh_head, sizeof mesh_head);
    Write(mesh.positions.data(), mesh.positions.size() * sizeof mesh.positions[0]);
    Write(mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
  }
  _exit(0);
}

/// Sets the time zone. libzip converts the times of an archive's entries to local time. Without a
/// set time zone, the C library would open a file for each conversion. The confined reader may open
/// no file.
void SettleTimeZone() {
  setenv("TZ", "UTC0", 1);
  tzset();
}

}  // namespace

void RunReader(const ReadFunction& read) {
  std::set_new_handler([] { _exit(kNoMemoryExit); });
  StepForwardWhenMemoryRunsOut();
  SettleTimeZone();
  PointHash::OfProcess();  // creates its keys now: a file for them cannot be opened later
  const std::string_view request = MapRequest();
  const RequestHead& head = *reinterpret_cast<const RequestHead*>(request.data());
  const absl::Status confined = Confine(head.confinement, head.limits, head.service_pid);
  if (!confined.ok()) AnswerError(AnswerKind::kNotConfined, std::string(confined.message()));
  const absl::StatusOr<MeshFileContents> contents =
      read(request.substr(sizeof head), head.format, head.coordinate_limit, head.depth);
  if (!contents.ok()) AnswerError(AnswerKind::kError, EncodeError(contents.status()));
  AnswerContents(*contents);
}

}  // namespace slicefarm::slicing
