#include "services/coordinator/algo/queue_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::coordinator::queue_order_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int64_t kNow = 1'000'000'000;
constexpr int64_t kRun = 10'000'000;  // the mean of kRuns
const std::vector<int64_t> kRuns = {5'000'000, 10'000'000, 15'000'000};

TenantQueue Waits(const std::string& tenant, const std::vector<int64_t>& numbers,
                  int64_t turn_us = 0, bool interactive = false) {
  TenantQueue queue = {.tenant = tenant, .turn_us = turn_us};
  for (const int64_t number : numbers) queue.waiting.push_back({number, interactive});
  return queue;
}

struct OrderCase {
  std::string name;
  QueueSnapshot queue;
  std::vector<int64_t> order;
};

class QueueOrderTest : public testing::TestWithParam<OrderCase> {};

TEST_P(QueueOrderTest, IsThatOfTheClaims) {
  std::vector<int64_t> numbers;
  for (const ExpectedRun& run : ExpectedRuns(GetParam().queue, kNow)) numbers.push_back(run.number);
  EXPECT_EQ(numbers, GetParam().order);
}

const HeldSlot kHeldA = {.tenant = "a", .owner = "one", .start_us = kNow};
const HeldSlot kHeldB = {.tenant = "b", .owner = "one", .start_us = kNow};
const HeldSlot kInteractiveA = {
    .tenant = "a", .owner = "one", .interactive = true, .start_us = kNow};

INSTANTIATE_TEST_SUITE_P(
    Queues, QueueOrderTest,
    testing::Values(
        OrderCase{"Nothing", {.held = {kHeldA}}, {}},
        OrderCase{"OneTenant", {.held = {kHeldA}, .tenants = {Waits("a", {3, 1, 2})}}, {3, 1, 2}},
        OrderCase{"NothingRuns", {.tenants = {Waits("a", {1, 2}), Waits("b", {3})}}, {1, 3, 2}},
        // The tenant without a held job comes before the tenant that has the only slot.
        OrderCase{"TenantsTakeTurns",
                  {.held = {kHeldA}, .tenants = {Waits("a", {1, 2, 3}, 7), Waits("b", {4, 5}, 6)}},
                  {4, 1, 5, 2, 3}},
        OrderCase{
            "TheLongestWithoutATurnIsFirst",
            {.held = {kHeldA, kHeldB}, .tenants = {Waits("c", {1, 2}, 9), Waits("d", {3, 4}, 8)}},
            {3, 1, 4, 2}},
        // One of the two slots is free for the idle tenant; the other one belongs to `a` until its
        // job ends.
        OrderCase{
            "FewestHeldFirst",
            {.held = {kHeldA, kHeldA}, .tenants = {Waits("a", {1, 2}, 9), Waits("b", {3, 4}, 1)}},
            {3, 1, 4, 2}},
        // A job of `a` already uses the slot for interactive jobs.
        OrderCase{"InteractiveJobsHaveAPlace",
                  {.held = {kHeldA, kInteractiveA},
                   .tenants = {Waits("a", {1, 2}), Waits("b", {5, 6, 7}, 0, true)}},
                  {5, 6, 1, 7, 2}},
        OrderCase{"AFreePlaceForInteractiveJobsIsTakenAtOnce",
                  {.held = {kHeldA}, .tenants = {Waits("a", {1, 2, 3}), Waits("c", {9}, 99, true)}},
                  {9, 1, 2, 3}}),
    [](const auto& info) { return info.param.name; });

TEST(ExpectedRuns, FollowOneAnotherAtThePlacesThereAre) {
  QueueSnapshot queue = {.held = {kHeldA, kHeldA}, .tenants = {Waits("a", {1, 2, 3})}};
  queue.held[0].start_us = kNow - kRun / 2;  // half done
  queue.runs_us = kRuns;
  EXPECT_EQ(MeanRunUs(queue), kRun);
  EXPECT_THAT(ExpectedRuns(queue, kNow),
              ElementsAre(ExpectedRun{1, kNow + kRun / 2, kNow + kRun / 2 + kRun},
                          ExpectedRun{2, kNow + kRun, kNow + 2 * kRun},
                          ExpectedRun{3, kNow + kRun / 2 + kRun, kNow + kRun / 2 + 2 * kRun}));
}

TEST(ExpectedRuns, AJobThatLastsLongIsExpectedToGoOn) {
  QueueSnapshot queue = {.held = {kHeldA}, .tenants = {Waits("a", {1})}, .runs_us = kRuns};
  queue.held[0].start_us = kNow - 6 * kRun;
  EXPECT_THAT(ExpectedRuns(queue, kNow),
              ElementsAre(ExpectedRun{1, kNow + 6 * kRun, kNow + 7 * kRun}));
}

TEST(MeanRun, OfTooFewIsUnknown) {
  EXPECT_EQ(MeanRunUs({.runs_us = {1, 2}}), 0);
  EXPECT_EQ(MeanRunUs({}), 0);
  EXPECT_THAT(ExpectedRuns({}, kNow), IsEmpty());
}

TEST(ExpectedRuns, HoldEachJobOnce) {
  QueueSnapshot queue = {.held = {kHeldA, kHeldB, kInteractiveA}};
  int64_t number = 0;
  for (const char* name : {"a", "b", "c", "d", "e"}) {
    TenantQueue& tenant = queue.tenants.emplace_back(Waits(name, {}));
    for (int i = 0; i < 200; ++i) tenant.waiting.push_back({++number, i < 50});
  }
  std::set<int64_t> numbers;
  int64_t last_us = 0;
  for (const ExpectedRun& run : ExpectedRuns(queue, kNow)) {
    EXPECT_TRUE(numbers.insert(run.number).second) << run.number;
    EXPECT_GE(run.start_us, last_us);
    last_us = run.start_us;
  }
  EXPECT_EQ(std::ssize(numbers), number);
}

}  // namespace
}  // namespace slicefarm::coordinator::queue_order_test
