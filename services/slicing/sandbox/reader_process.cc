#include "services/slicing/sandbox/reader_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "common/base/error.h"
#include "services/slicing/sandbox/sanitized_build.h"

extern char** environ;

namespace slicefarm::slicing {
namespace {

/// Longest time until a cancelled call is noticed.
constexpr int kCancelPollMs = 5;
/// Poll interval for the end of the reader. The reader ends within a fraction of this after it
/// closes stdout.
constexpr int kEndPollMs = 1;
/// Size of the pipe. With the usual 64 KiB, the system would switch more often between the two
/// programs.
constexpr int kPipeBytes = 1 << 20;

absl::Status CannotStart(std::string_view what, int error) {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   fmt::format("cannot start a mesh reader: {}: {}", what, strerrordesc_np(error)));
}

/// Arguments of posix_spawn. Its C structs must be destroyed.
class SpawnPlan {
 public:
  SpawnPlan(int request, int answer) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, request, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files_, answer, STDOUT_FILENO);
    // stderr is discarded: a hostile file may control the reader, and its messages do not belong in
    // a log.
    if (!kSanitizedBuild)
      posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    SetSignals();
  }
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  /// Starts the program and returns 0 or an errno. The reader gets none of the service's
  /// environment variables. Huge pages save it thousands of page faults, because all its memory is
  /// new.
  int Spawn(const std::string& program, pid_t* pid) const {
    char* const arguments[] = {const_cast<char*>(program.c_str()), nullptr};
    char big_pages[] = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1";
    char* const environment[] = {big_pages, nullptr};
    return posix_spawn(pid, program.c_str(), &files_, &attributes_, arguments,
                       kSanitizedBuild ? environ : environment);
  }

 private:
  void SetSignals() {
    sigset_t deaf_to, as_usual;
    sigemptyset(&deaf_to);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&deaf_to, signal);
    sigfillset(&as_usual);
    posix_spawnattr_setsigmask(&attributes_, &deaf_to);
    posix_spawnattr_setsigdefault(&attributes_, &as_usual);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }

  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

/// Returns true if there is something to read or the input has ended.
bool AwaitReadable(int fd, int timeout_ms) {
  pollfd entry = {.fd = fd, .events = POLLIN, .revents = 0};
  return poll(&entry, 1, timeout_ms) > 0;
}

}  // namespace

absl::StatusOr<ReaderProcess> ReaderProcess::Start(const std::string& program, const Fd& request) {
  std::array<int, 2> ends = {};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return CannotStart("a pipe", errno);
  Fd answer(ends[0]);
  const Fd its_end(ends[1]);
  (void)fcntl(its_end.number(), F_SETPIPE_SZ, kPipeBytes);  // a smaller pipe also works
  pid_t pid = 0;
  const int error = SpawnPlan(request.number(), its_end.number()).Spawn(program, &pid);
  if (error != 0) return CannotStart(program, error);
  return ReaderProcess(pid, std::move(answer));
}

ReaderProcess::ReaderProcess(ReaderProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)), answer_(std::move(other.answer_)) {}

ReaderProcess::~ReaderProcess() {
  if (pid_ == 0) return;
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

absl::StatusOr<bool> ReaderProcess::Receive(std::span<char> bytes, const CancelToken& cancel) {
  while (!bytes.empty()) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    if (!AwaitReadable(answer_.number(), kCancelPollMs)) continue;
    const ssize_t size = read(answer_.number(), bytes.data(), bytes.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    bytes = bytes.subspan(static_cast<size_t>(size));
  }
  return true;
}

absl::StatusOr<ProcessEnd> ReaderProcess::AwaitEnd(const CancelToken& cancel) {
  for (;;) {
    ProcessEnd end;
    rusage usage = {};
    const pid_t ended = wait4(pid_, &end.wait_status, WNOHANG, &usage);
    if (ended == pid_) {
      pid_ = 0;
      end.cpu_s = Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
      return end;
    }
    if (ended < 0 && errno != EINTR) {
      pid_ = 0;  // the id may belong to another process now
      return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                       "a mesh reader's end was taken by somebody else");
    }
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    poll(nullptr, 0, kEndPollMs);
  }
}

}  // namespace slicefarm::slicing
