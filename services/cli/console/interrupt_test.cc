#include "services/cli/console/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "services/cli/console/exit_code.h"

namespace slicefarm::cli::interrupt_test {
namespace {

constexpr int kCancelled = static_cast<int>(ExitCode::kCancelled);

[[noreturn]] void SleepForGood() {
  for (;;) pause();
}

TEST(Interrupt, TheProgramSeesTheFirstSignal) {
  for (const int signal : {SIGINT, SIGTERM})
    EXPECT_EXIT(
        {
          Interrupt interrupt;
          interrupt.WaitForEnd();
          const CancelToken token = interrupt.Token();
          if (token.Cancelled()) _exit(1);
          kill(getpid(), signal);
          while (!token.Cancelled()) std::this_thread::yield();
          _exit(3);
        },
        testing::ExitedWithCode(3), "");
}

TEST(Interrupt, TheSecondSignalEndsAProgramThatMayTakeItsTime) {
  for (const int second : {SIGINT, SIGTERM})
    EXPECT_EXIT(
        {
          Interrupt interrupt;
          interrupt.WaitForEnd();
          kill(getpid(), SIGINT);
          while (!interrupt.Requested()) std::this_thread::yield();
          kill(getpid(), second);
          SleepForGood();
        },
        testing::ExitedWithCode(kCancelled), "cancelled");
}

TEST(Interrupt, TheFirstSignalEndsAProgramThatDoesNotLook) {
  for (const int signal : {SIGINT, SIGTERM})
    EXPECT_EXIT(
        {
          Interrupt interrupt;
          kill(getpid(), signal);
          SleepForGood();
        },
        testing::ExitedWithCode(kCancelled), "cancelled");
}

}  // namespace
}  // namespace slicefarm::cli::interrupt_test
