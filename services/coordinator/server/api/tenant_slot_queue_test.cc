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

/// Call that waits for its turn on a thread of its own.
class Call {
 public:
  Call(TenantSlotQueue& turns, const std::string& tenant)
      : thread_([this, &turns, tenant] {
          const CancelToken cancel([this] {
            polled_ = true;
            return given_up_.load();
          });
          auto turn = turns.Enter(tenant, cancel);
          if (turn.ok()) turn_.emplace(*std::move(turn));
          done_ = true;
        }) {}
  ~Call() {
    given_up_ = true;
    thread_.join();
  }

  void AwaitWaiting() const {
    while (!polled_) std::this_thread::yield();
  }
  bool AwaitTurn() const {
    while (!done_) std::this_thread::yield();
    return turn_.has_value();
  }
  bool working() const { return done_; }

 private:
  std::atomic<bool> given_up_ = false;
  std::atomic<bool> polled_ = false;
  std::atomic<bool> done_ = false;
  std::optional<TenantSlotQueue::Slot> turn_;
  std::thread thread_;
};

TEST(TenantSlotQueue, ATenantLeavesASlotForTheOthers) {
  TenantSlotQueue turns(4);
  Call one(turns, "a");
  ASSERT_TRUE(one.AwaitTurn());
  Call two(turns, "a");
  ASSERT_TRUE(two.AwaitTurn());
  Call three(turns, "a");
  three.AwaitWaiting();
  EXPECT_TRUE(Call(turns, "b").AwaitTurn()) << "though a call of a came before";
  EXPECT_FALSE(three.working());
}

TEST(TenantSlotQueue, WhoHasTheLeastAtWorkComesFirst) {
  TenantSlotQueue turns(2);
  auto first = std::make_unique<Call>(turns, "a");
  ASSERT_TRUE(first->AwaitTurn());
  Call again(turns, "a");
  again.AwaitWaiting();
  auto of_b = std::make_unique<Call>(turns, "b");
  ASSERT_TRUE(of_b->AwaitTurn());
  Call of_c(turns, "c");
  of_c.AwaitWaiting();
  of_b.reset();
  EXPECT_TRUE(of_c.AwaitTurn());
  EXPECT_FALSE(again.working());
  first.reset();
  EXPECT_TRUE(again.AwaitTurn());
}

TEST(TenantSlotQueue, WhoGivesUpKeepsNobodyWaiting) {
  TenantSlotQueue turns(1);
  auto holder = std::make_unique<Call>(turns, "");
  ASSERT_TRUE(holder->AwaitTurn());
  {
    Call quitter(turns, "");
    quitter.AwaitWaiting();
  }
  Call next(turns, "");
  next.AwaitWaiting();
  holder.reset();
  EXPECT_TRUE(next.AwaitTurn());
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_slot_queue_test
