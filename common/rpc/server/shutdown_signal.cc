#include "common/rpc/server/shutdown_signal.h"

#include <pthread.h>

namespace slicefarm::rpc {

ShutdownSignal::ShutdownSignal() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
}

int ShutdownSignal::Wait() const {
  int signal = 0;
  while (sigwait(&signals_, &signal) != 0) {
  }
  return signal;
}

bool ShutdownSignal::WaitFor(std::chrono::milliseconds time) const {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  const std::chrono::nanoseconds rest = time - seconds;
  const timespec limit = {seconds.count(), rest.count()};
  return sigtimedwait(&signals_, nullptr, &limit) > 0;
}

}  // namespace slicefarm::rpc
