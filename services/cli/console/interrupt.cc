#include "services/cli/console/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>

#include "services/cli/console/exit_code.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli {
namespace {

/// Time that the program has to end by itself.
constexpr timespec kGrace = {.tv_sec = 0, .tv_nsec = 300'000'000};

sigset_t Signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Ends the program without waiting for other threads, which may have any lock except the one for
/// files.
[[noreturn]] void EndNow() {
  RemovePartialFiles();
  constexpr std::string_view kWords = "\nerror: cancelled\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kWords.data(), kWords.size());
  _exit(static_cast<int>(ExitCode::kCancelled));
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t signals = Signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // later threads inherit the mask
  thread_ = std::thread([this] { Wait(); });
}

Interrupt::~Interrupt() {
  ending_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

CancelToken Interrupt::Token() const {
  return CancelToken([this] { return Requested(); });
}

/// Returns at the next signal, or when the time is over.
void Interrupt::AwaitEnd() const {
  const sigset_t signals = Signals();
  while (sigtimedwait(&signals, nullptr, &kGrace) < 0)
    if (errno == EAGAIN && !waits_for_end_) return;
}

void Interrupt::Wait() {
  const sigset_t signals = Signals();
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) continue;
  if (ending_) return;
  requested_ = true;
  AwaitEnd();
  if (!ending_) EndNow();
}

}  // namespace slicefarm::cli
