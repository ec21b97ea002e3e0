#include "services/coordinator/run/lease_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::coordinator::lease_table_test {
namespace {

using testing::ElementsAre;

constexpr int64_t kLeaseUs = 10'000;

class LeaseBookTest : public testing::Test {
 protected:
  std::shared_ptr<RunRequests> Add(const Lease& lease, int64_t claimed_us = 0) {
    auto wishes = std::make_shared<RunRequests>();
    book_.Add(lease, claimed_us, wishes);
    return wishes;
  }

  LeaseTable book_{kLeaseUs};
};

TEST_F(LeaseBookTest, RunsAreRenewedUntilTheyEnd) {
  Add({"a", 1});
  const auto lost = Add({"b", 1});
  Add({"c", 1});
  lost->Lose();
  book_.Remove({"c", 1});
  EXPECT_THAT(book_.ToRenew(), ElementsAre(Lease{"a", 1}));
}

TEST_F(LeaseBookTest, WhatTheStoreDoesNotHoldAnyMoreIsLost) {
  const auto old = Add({"a", 1});
  const auto wanted = Add({"b", 1});
  const auto cancelled = Add({"c", 1});
  const auto asked = book_.ToRenew();
  const auto claimed_meanwhile = Add({"a", 2});
  book_.Remove({"b", 1});
  book_.Renewed(asked, {{{"c", 1}, true}}, 5'000);
  EXPECT_TRUE(old->lost());
  EXPECT_FALSE(wanted->GivenUp(0)) << "it has ended";
  EXPECT_TRUE(cancelled->cancelled());
  EXPECT_FALSE(cancelled->lost());
  EXPECT_FALSE(claimed_meanwhile->GivenUp(0)) << "it was not asked for";
}

TEST_F(LeaseBookTest, AStoreThatDoesNotAnswerCostsARunOnlyLate) {
  const auto run = Add({"a", 1}, /*claimed_us=*/0);
  book_.GiveUpLate(8'000);
  EXPECT_FALSE(run->lost());
  book_.Renewed({{"a", 1}}, {{{"a", 1}, false}}, 13'000);
  book_.GiveUpLate(11'000);
  EXPECT_FALSE(run->lost());
  book_.GiveUpLate(11'001);
  EXPECT_TRUE(run->lost());
}

TEST_F(LeaseBookTest, RunsHearOfADeadlineThatWasChanged) {
  const auto run = Add({"a", 1});
  book_.Renewed({{"a", 1}}, {{{"a", 1}, false, 7'000}}, 13'000);
  EXPECT_FALSE(run->Overdue(6'999));
  EXPECT_TRUE(run->Overdue(7'000));
}

TEST_F(LeaseBookTest, WishesReachTheRunsTheyAreFor) {
  const auto a = Add({"a", 1});
  const auto b = Add({"b", 1});
  book_.Cancel("a");
  EXPECT_TRUE(a->cancelled());
  EXPECT_FALSE(b->GivenUp(0));
  book_.HandBackAll();
  EXPECT_TRUE(a->handed_back());
  EXPECT_TRUE(b->handed_back());
}

}  // namespace
}  // namespace slicefarm::coordinator::lease_table_test
