#include "common/rpc/server/admission.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc::admission_test {
namespace {

void AwaitWaiting(const Admission& admission, int count) {
  while (admission.waiting() != count) std::this_thread::yield();
}

TEST(Admission, GivesAsManyTurnsAsItHasSlots) {
  Admission admission(2, 0);
  std::optional<Admission::Ticket> first = *admission.Enter({});
  const Admission::Ticket second = *admission.Enter({});
  EXPECT_EQ(admission.working(), 2);
  const absl::Status status = admission.Enter({}).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOverloaded);
  EXPECT_EQ(DetailOf(status).metadata["limit"], "2");
  EXPECT_NE(DetailOf(status).metadata[kRetryAfterMs], "");
  first.reset();
  EXPECT_TRUE(admission.Enter({}).ok());
}

TEST(Admission, AQueuedCallGetsTheNextTurn) {
  Admission admission(1, 1);
  std::optional<Admission::Ticket> first = *admission.Enter({});
  std::thread waiter([&] { EXPECT_TRUE(admission.Enter({}).ok()); });
  AwaitWaiting(admission, 1);
  EXPECT_FALSE(admission.Enter({}).ok());  // the queue is full
  first.reset();
  waiter.join();
  EXPECT_EQ(admission.working(), 0);
}

TEST(Admission, ACancelledCallLeavesTheQueue) {
  Admission admission(1, 1);
  const Admission::Ticket first = *admission.Enter({});
  std::atomic<bool> cancelled = false;
  std::thread waiter([&] {
    const absl::Status status =
        admission.Enter(CancelToken([&] { return cancelled.load(); })).status();
    EXPECT_TRUE(absl::IsCancelled(status)) << status;
  });
  AwaitWaiting(admission, 1);
  cancelled = true;
  waiter.join();
  EXPECT_EQ(admission.waiting(), 0);
  EXPECT_EQ(admission.working(), 1);
}

TEST(Admission, NeverLetsMoreWorkThanSlots) {
  Admission admission(3, 100);
  std::atomic<int> working = 0;
  std::atomic<int> most = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 16; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 200; ++round) {
        const auto ticket = admission.Enter({});
        ASSERT_TRUE(ticket.ok());
        const int now = ++working;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
        }
        std::this_thread::yield();
        --working;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(most, 3);
  EXPECT_EQ(admission.working(), 0);
  EXPECT_EQ(admission.waiting(), 0);
}

}  // namespace
}  // namespace slicefarm::rpc::admission_test
