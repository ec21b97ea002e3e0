#include "services/coordinator/server/api/tenant_slot_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace slicefarm::coordinator::tenant_slot_queue_test {
namespace {

/// Call that waits for its slot on a thread of its own.
class Call {
 public:
  Call(TenantSlotQueue& queue, const std::string& tenant)
      : thread_([this, &queue, tenant] {
          const CancelToken cancel([this] {
            polled_ = true;
            return given_up_.load();
          });
          auto slot = queue.Enter(tenant, cancel);
          if (slot.ok()) slot_.emplace(*std::move(slot));
          done_ = true;
        }) {}
  ~Call() {
    given_up_ = true;
    thread_.join();
  }

  void AwaitWaiting() const {
    while (!polled_) std::this_thread::yield();
  }
  bool AwaitSlot() const {
    while (!done_) std::this_thread::yield();
    return slot_.has_value();
  }
  bool working() const { return done_; }

 private:
  std::atomic<bool> given_up_ = false;
  std::atomic<bool> polled_ = false;
  std::atomic<bool> done_ = false;
  std::optional<TenantSlotQueue::Slot> slot_;
  std::thread thread_;
};

TEST(TenantSlotQueue, ATenantLeavesASlotForTheOthers) {
  TenantSlotQueue queue(4);
  Call one(queue, "a");
  ASSERT_TRUE(one.AwaitSlot());
  Call two(queue, "a");
  ASSERT_TRUE(two.AwaitSlot());
  Call three(queue, "a");
  three.AwaitWaiting();
  EXPECT_TRUE(Call(queue, "b").AwaitSlot()) << "though a call of a came before";
  EXPECT_FALSE(three.working());
}

TEST(TenantSlotQueue, WhoHasTheLeastAtWorkComesFirst) {
  TenantSlotQueue queue(2);
  auto first = std::make_unique<Call>(queue, "a");
  ASSERT_TRUE(first->AwaitSlot());
  Call again(queue, "a");
  again.AwaitWaiting();
  auto of_b = std::make_unique<Call>(queue, "b");
  ASSERT_TRUE(of_b->AwaitSlot());
  Call of_c(queue, "c");
  of_c.AwaitWaiting();
  of_b.reset();
  EXPECT_TRUE(of_c.AwaitSlot());
  EXPECT_FALSE(again.working());
  first.reset();
  EXPECT_TRUE(again.AwaitSlot());
}

TEST(TenantSlotQueue, WhoGivesUpKeepsNobodyWaiting) {
  TenantSlotQueue queue(1);
  auto holder = std::make_unique<Call>(queue, "");
  ASSERT_TRUE(holder->AwaitSlot());
  {
    Call quitter(queue, "");
    quitter.AwaitWaiting();
  }
  Call next(queue, "");
  next.AwaitWaiting();
  holder.reset();
  EXPECT_TRUE(next.AwaitSlot());
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_slot_queue_test
