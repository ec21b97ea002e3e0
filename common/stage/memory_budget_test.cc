#include "common/stage/memory_budget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::memory_budget_test {
namespace {

using Kind = JobMemory::Kind;
using SharePtr = std::unique_ptr<MemoryBudget::Share>;

const Claimant kAnna = {"anna", 1};
const Claimant kBert = {"bert", 1};
const Claimant kUrgentBert = {"bert", 2};

/// Thread that requests memory. It waits until the request is granted, and then until the test
/// releases it.
class Asker {
 public:
  Asker(MemoryBudget& budget, const Claimant& who, const std::string& job, int64_t bytes) {
    thread_ = std::thread([this, &budget, who, job, bytes] {
      const auto share = budget.Take(who, job, bytes, Token());
      had_ = share.ok();
      while (!let_go_) std::this_thread::yield();
    });
    AwaitPoll();
  }
  /// Requests more memory for an existing share.
  Asker(MemoryBudget::Share& share, int64_t bytes) {
    thread_ = std::thread([this, &share, bytes] {
      status_ = share.Hold(Kind::kOutlines, bytes);
      had_ = true;
    });
  }
  ~Asker() {
    LetGo();
    if (thread_.joinable()) thread_.join();
  }

  bool had() const { return had_; }
  void AwaitHad() const {
    while (!had_) std::this_thread::yield();
  }
  void LetGo() { let_go_ = true; }
  absl::Status Join() {
    thread_.join();
    return status_;
  }

 private:
  CancelToken Token() {
    return CancelToken([this] {
      polled_ = true;
      return false;
    });
  }
  void AwaitPoll() const {
    while (!polled_ && !had_) std::this_thread::yield();
  }

  std::atomic<bool> polled_ = false;
  std::atomic<bool> had_ = false;
  std::atomic<bool> let_go_ = false;
  absl::Status status_;
  std::thread thread_;
};

SharePtr Taken(MemoryBudget& budget, const Claimant& who, int64_t bytes,
               const std::string& job = "") {
  auto share = budget.Take(who, job, bytes, {});
  EXPECT_TRUE(share.ok()) << share.status();
  return *std::move(share);
}

bool Refused(MemoryBudget& budget, const Claimant& who, int64_t bytes) {
  return absl::IsCancelled(budget.Take(who, "", bytes, CancelToken([] { return true; })).status());
}

TEST(MemoryBudget, WhatDoesNotFitWaitsForRoom) {
  MemoryBudget budget(10);
  SharePtr first = Taken(budget, kAnna, 6);
  const SharePtr second = Taken(budget, kAnna, 4);
  Asker third(budget, kAnna, "", 5);
  EXPECT_FALSE(third.had());
  first.reset();
  third.AwaitHad();
  EXPECT_EQ(budget.used(), 9);
}

TEST(MemoryBudget, WhatDoesNotFitAloneIsAnError) {
  MemoryBudget budget(10);
  const absl::Status status = budget.Take(kAnna, "", 11, {}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), "10");
  EXPECT_EQ(DetailOf(status).metadata.at("got"), "11");
  const SharePtr share = Taken(budget, kAnna, 10);
  const absl::Status grown = share->Hold(Kind::kOutlines, 1);
  EXPECT_EQ(DetailOf(grown).reason, Reason::kRequestTooLarge);
  EXPECT_TRUE(IsOutOfMemory(grown));
}

TEST(MemoryBudget, WhoGivesUpKeepsNobodyWaiting) {
  MemoryBudget budget(10);
  const SharePtr some = Taken(budget, kAnna, 5);
  EXPECT_TRUE(Refused(budget, kAnna, 6));
  EXPECT_EQ(Taken(budget, kAnna, 5)->Hold(Kind::kMeshes, 0), absl::OkStatus());
  EXPECT_EQ(budget.used(), 5);
}

TEST(MemoryBudget, FirstComesTheTenantWithLeastThenPriorityThenAge) {
  MemoryBudget budget(10);
  SharePtr most = Taken(budget, kAnna, 6);
  SharePtr little = Taken(budget, kBert, 4);
  Asker older(budget, kAnna, "", 9);
  Asker poorer(budget, kBert, "", 9);
  Asker urgent(budget, kUrgentBert, "", 9);
  little.reset();
  EXPECT_FALSE(older.had() || poorer.had() || urgent.had()) << "none fits yet";
  most.reset();
  urgent.AwaitHad();
  EXPECT_FALSE(older.had() || poorer.had());
  urgent.LetGo();
  older.AwaitHad();  // nobody has anything now, and it waits longest
  EXPECT_FALSE(poorer.had());
  older.LetGo();
  poorer.AwaitHad();
}

TEST(MemoryBudget, ALargeOneIsPassedByAsMuchAsThereIsAndNoMore) {
  MemoryBudget budget(10);
  SharePtr some = Taken(budget, kAnna, 1);
  Asker large(budget, kAnna, "", 10);
  for (int i = 0; i < 10; ++i) Taken(budget, kAnna, 1);
  EXPECT_TRUE(Refused(budget, kAnna, 1)) << "ten have passed it";
  EXPECT_TRUE(Refused(budget, kUrgentBert, 1)) << "whoever asks";
  some.reset();
  large.AwaitHad();
}

TEST(MemoryBudget, WhoHasBegunComesBeforeWhoHasNot) {
  MemoryBudget budget(10);
  const SharePtr begun = Taken(budget, kAnna, 4);
  SharePtr other = Taken(budget, kAnna, 4);
  Asker more(*begun, 6);
  while (!Refused(budget, kUrgentBert, 1)) std::this_thread::yield();
  EXPECT_FALSE(more.had());
  other.reset();
  EXPECT_EQ(more.Join(), absl::OkStatus());
  EXPECT_EQ(budget.used(), 10);
}

// Two jobs that each wait for the memory of the other job would wait for ever.
TEST(MemoryBudget, OfTwoThatWantMoreTheLastOneMakesRoom) {
  for (const bool last_asks_first : {false, true}) {
    MemoryBudget budget(10);
    SharePtr first = Taken(budget, kAnna, 4, "first");
    SharePtr last = Taken(budget, kAnna, 4, "last");
    SharePtr& asks_first = last_asks_first ? last : first;
    SharePtr& asks_then = last_asks_first ? first : last;
    Asker one(*asks_first, 3);
    while (!Refused(budget, kAnna, 1)) std::this_thread::yield();
    Asker other(*asks_then, 3);
    const absl::Status freed_memory = (last_asks_first ? one : other).Join();
    EXPECT_EQ(DetailOf(freed_memory).reason, Reason::kOverloaded);
    EXPECT_TRUE(IsOutOfMemory(freed_memory));
    last.reset();
    EXPECT_EQ((last_asks_first ? other : one).Join(), absl::OkStatus());
    EXPECT_TRUE(Refused(budget, kAnna, 10)) << "of others' jobs nothing is known";
    first.reset();
    const SharePtr again = Taken(budget, kAnna, 4, "last");
    EXPECT_EQ(budget.used(), 10) << "twice what it asked for, as far as there is as much";
  }
}

TEST(MemoryBudget, WhatWasHeldOfAKindIsReplaced) {
  MemoryBudget budget(100);
  const SharePtr share = Taken(budget, kAnna, 40);
  for (int64_t bytes = 0; bytes <= 60; bytes += 20)
    EXPECT_EQ(share->Hold(Kind::kOutlines, bytes), absl::OkStatus());
  EXPECT_EQ(budget.used(), 100);
  EXPECT_EQ(share->Hold(Kind::kMeshes, 0), absl::OkStatus());
  EXPECT_EQ(share->Hold(Kind::kPlan, 40), absl::OkStatus());
  EXPECT_EQ(share->Hold(Kind::kOutlines, 5), absl::OkStatus());
  EXPECT_EQ(budget.used(), 45);
}

TEST(MemoryBudget, EverybodyIsServedInTheEnd) {
  MemoryBudget budget(100);
  std::atomic<int> done = 0;
  std::vector<std::thread> jobs;
  for (int j = 0; j < 8; ++j)
    jobs.emplace_back([&, j] {
      for (int round = 0; round < 20; ++round) {
        const std::string id = std::to_string(j * 100 + round);
        for (bool over = false; !over;) {
          const auto share = budget.Take(j % 2 ? kAnna : kBert, id, 10 + j, {});
          ASSERT_TRUE(share.ok()) << share.status();
          over = true;
          for (int64_t bytes = 0; over && bytes <= 60; bytes += 10)
            over = (*share)->Hold(Kind::kOutlines, bytes).ok();
          EXPECT_LE(budget.used(), 100);
        }
        ++done;
      }
    });
  for (std::thread& job : jobs) job.join();
  EXPECT_EQ(done, 160);
  EXPECT_EQ(budget.used(), 0);
}

}  // namespace
}  // namespace slicefarm::memory_budget_test
