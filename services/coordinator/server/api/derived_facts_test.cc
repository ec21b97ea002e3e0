#include "services/coordinator/server/api/derived_facts.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <vector>

#include "common/base/sha256.h"
#include "common/rpc/event_test.h"

namespace slicefarm::coordinator::derived_facts_test {
namespace {

TEST(DerivedFacts, AreMadeOnceForAllWhoAsk) {
  DerivedFacts facts;
  std::atomic<int> made = 0;
  Event begun;
  Event go_on;
  const auto make = [&]() -> absl::StatusOr<std::string> {
    ++made;
    begun.Happen();
    go_on.Await();
    return "layers";
  };
  std::vector<std::future<absl::StatusOr<DerivedFacts::Fact>>> asking;
  for (int i = 0; i < 8; ++i)
    asking.push_back(std::async(std::launch::async, [&] { return facts.Of("a", {}, make); }));
  begun.Await();
  go_on.Happen();
  for (auto& each : asking) {
    const auto fact = each.get();
    ASSERT_TRUE(fact.ok()) << fact.status();
    EXPECT_EQ(fact->size, 6);
    EXPECT_EQ(fact->sha256, Sha256Hex("layers"));
  }
  EXPECT_TRUE(facts.Of("a", {}, make).ok());
  EXPECT_EQ(made, 1);
}

TEST(DerivedFacts, WhatIsNotThereIsKnownToo) {
  DerivedFacts facts;
  int made = 0;
  const auto make = [&]() -> absl::StatusOr<std::string> {
    ++made;
    return absl::NotFoundError("no layers");
  };
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(absl::IsNotFound(facts.Of("a", {}, make).status()));
  EXPECT_EQ(made, 1);
}

TEST(DerivedFacts, TheNextOneMakesWhatTheFirstGaveUp) {
  DerivedFacts facts;
  const auto gives_up = [] { return absl::StatusOr<std::string>(absl::CancelledError("left")); };
  EXPECT_TRUE(absl::IsCancelled(facts.Of("a", {}, gives_up).status()));
  const auto fact = facts.Of("a", {}, [] { return absl::StatusOr<std::string>("x"); });
  ASSERT_TRUE(fact.ok()) << fact.status();
  EXPECT_EQ(fact->size, 1);
}

TEST(DerivedFacts, WhoWaitsMayLeave) {
  DerivedFacts facts;
  Event begun;
  Event go_on;
  auto first = std::async(std::launch::async, [&] {
    return facts.Of("a", {}, [&]() -> absl::StatusOr<std::string> {
      begun.Happen();
      go_on.Await();
      return "x";
    });
  });
  begun.Await();
  const CancelToken left([] { return true; });
  const auto never = [] { return absl::StatusOr<std::string>(absl::InternalError("made twice")); };
  EXPECT_TRUE(absl::IsCancelled(facts.Of("a", left, never).status()));
  go_on.Happen();
  EXPECT_TRUE(first.get().ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::derived_facts_test
