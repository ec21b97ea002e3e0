#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/sandbox/project_codec.h"
#include "services/slicing/sandbox/reader_protocol.h"
#include "services/slicing/sandbox/reader_side.h"

// Test program that replaces slicefarm-mesh-reader and acts like a reader taken over by a hostile
// mesh. The file names the misbehaviour; a file without such a name is read normally.

namespace slicefarm::slicing {
namespace {

using Answer = absl::StatusOr<MeshFileContents>;

/// Returns a text to the test, as the error of a mesh.
Answer Report(const std::string& what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed, what);
}

Answer ReportErrno(int result) { return Report(result < 0 ? strerrorname_np(errno) : "done"); }

Answer Crash() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
  return Report("still here");
}

Answer Eat() {
  for (std::vector<std::string> eaten;;) eaten.emplace_back(1 << 20, 'x');
}

Answer Spin() {
  for (;;) std::atomic_signal_fence(std::memory_order_seq_cst);
}

/// Closes stdout while the process stays alive.
Answer Hide() {
  close(STDOUT_FILENO);
  for (;;) pause();
}

[[noreturn]] void Say(const void* bytes, size_t size) {
  (void)!write(STDOUT_FILENO, bytes, size);
  _exit(0);
}

Answer Babble() {
  const std::string noise(1000, 'x');
  Say(noise.data(), noise.size());
}

[[noreturn]] void SayHead(AnswerHead head) {
  head.build_id = ThisBuild();
  Say(&head, sizeof head);
}

MeshFileContents Alone(const RawMesh& mesh) {
  Project project;
  SceneObject& object = project.objects.emplace_back();
  object.parts.emplace_back();
  object.instances.emplace_back();
  return {{mesh}, project};
}

/// Announces a mesh and then does not send it.
[[noreturn]] void SayMeshHead(const MeshHead& mesh) {
  const std::string project = EncodeProject(Alone({}).project);
  const AnswerHead head = {.build_id = ThisBuild(), .project_bytes = project.size(), .meshes = 1};
  std::string all(reinterpret_cast<const char*>(&head), sizeof head);
  all += project;
  all.append(reinterpret_cast<const char*>(&mesh), sizeof mesh);
  Say(all.data(), all.size());
}

Answer Break() { SayMeshHead({.positions = 3, .triangles = 1}); }
Answer Boast() { SayMeshHead({.positions = 30'000'000, .triangles = 10'000'000}); }
Answer Wrap() { SayMeshHead({.positions = UINT64_MAX / 8, .triangles = UINT64_MAX / 8}); }
Answer Swell() { SayHead({.project_bytes = UINT64_MAX / 2, .meshes = 1}); }
Answer Multiply() { SayHead({.project_bytes = 1, .meshes = UINT64_MAX}); }
Answer Withhold() { SayHead({.project_bytes = 1, .meshes = 0}); }
Answer Invent() { SayHead({.kind = static_cast<AnswerKind>(77)}); }
Answer Ramble() { SayHead({.kind = AnswerKind::kError, .error_bytes = 0xffffffff}); }
Answer BeAnother() {
  const AnswerHead head = {.build_id = {'a', 'n', 'o', 't', 'h', 'e', 'r'}};
  Say(&head, sizeof head);
}

/// Returns an error that would make the job be retried again and again.
Answer Excuse() {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "try again");
}

RawMesh Triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}; }

Answer Overreach() {
  RawMesh mesh = Triangle();
  mesh.triangles[0][2] = 3;
  return Alone(mesh);
}

/// Returns a project that refers to missing objects.
Answer Misplace(void (*change)(Project&)) {
  MeshFileContents contents = Alone(Triangle());
  change(contents.project);
  return contents;
}

Answer WithCorner(double x) {
  RawMesh mesh = Triangle();
  mesh.positions[0].x() = x;
  return Alone(mesh);
}

/// Returns the blocked signals: SIGTERM and similar signals must not reach a reader while its
/// service still waits for it.
std::string DeafTo() {
  std::string deaf = "deaf to";
  sigset_t blocked;
  sigprocmask(SIG_SETMASK, nullptr, &blocked);
  for (int signal = 1; signal < 32; ++signal)
    if (sigismember(&blocked, signal) == 1) deaf += " " + std::to_string(signal);
  return deaf;
}

/// Returns the environment of a reader: "SECRET", descriptors above stderr, process traits.
Answer LookAround() {
  int open = 0;
  for (int fd = 3; fd < 1024; ++fd) open += fcntl(fd, F_GETFD) >= 0;
  return Report(std::string(getenv("SECRET") != nullptr ? "told" : "untold") + " " +
                std::to_string(open) + " open, dumpable " + std::to_string(prctl(PR_GET_DUMPABLE)) +
                ", no new privileges " + std::to_string(prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0)) +
                ", " + DeafTo());
}

Answer TryFile() { return ReportErrno(open("/etc/passwd", O_RDONLY)); }
Answer TrySocket() { return ReportErrno(socket(AF_INET, SOCK_STREAM, 0)); }
Answer TryWrite() { return ReportErrno(static_cast<int>(write(STDERR_FILENO, "x", 1))); }
Answer TryFork() {
  const pid_t pid = fork();
  if (pid == 0) _exit(0);
  return ReportErrno(pid);
}
Answer TryProgram() { return ReportErrno(execl("/bin/true", "true", nullptr)); }

const std::map<std::string_view, std::function<Answer()>, std::less<>>& Deeds() {
  static const std::map<std::string_view, std::function<Answer()>, std::less<>> deeds = {
      {"crash", Crash},
      {"eat", Eat},
      {"spin", Spin},
      {"hide", Hide},
      {"babble", Babble},
      {"break", Break},
      {"boast", Boast},
      {"wrap", Wrap},
      {"swell", Swell},
      {"multiply", Multiply},
      {"withhold", Withhold},
      {"refer beyond",
       [] { return Misplace([](Project& p) { p.objects[0].parts[0].mesh.mesh = 1; }); }},
      {"say no role",
       [] {
         return Misplace(
             [](Project& p) { p.objects[0].parts[0].role = static_cast<PartRole>(77); });
       }},
      {"say no text", [] { return Misplace([](Project& p) { p.objects[0].name = "\xff"; }); }},
      {"invent", Invent},
      {"ramble", Ramble},
      {"be another", BeAnother},
      {"excuse", Excuse},
      {"overreach", Overreach},
      {"say nan", [] { return WithCorner(std::numeric_limits<double>::quiet_NaN()); }},
      {"say infinity", [] { return WithCorner(std::numeric_limits<double>::infinity()); }},
      {"say far", [] { return WithCorner(-1e9); }},
      {"look around", LookAround},
      {"open", TryFile},
      {"socket", TrySocket},
      {"write", TryWrite},
      {"fork", TryFork},
      {"exec", TryProgram},
  };
  return deeds;
}

}  // namespace
}  // namespace slicefarm::slicing

int main() {
  using namespace slicefarm::slicing;
  (void)Deeds();  // created while everything is still allowed
  RunReader([](std::string_view bytes, slicefarm::MeshFormat format, double limit,
               ReadDepth depth) {
    // The text is padded with blanks, because the size of a file limits the size of the answer.
    const std::string_view deed = bytes.substr(0, bytes.find_last_not_of(' ') + 1);
    const auto found = Deeds().find(deed);
    return found != Deeds().end() ? found->second() : ReadMeshFile(bytes, format, limit, depth, {});
  });
}
