#include "services/cli/interrupt.h"

#include <pthread.h>

#include <csignal>
namespace slicefarm::cli {
namespace {

sigset_t Signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t signals = Signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // all threads to come inherit it
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

void Interrupt::Wait() {
  const sigset_t signals = Signals();
  for (;;) {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0) continue;
    if (ending_) return;
    if (requested_) {
      pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
      raise(signal);  // its usual effect: the end of the program
    }
    requested_ = true;
  }
}

}  // namespace slicefarm::cli
