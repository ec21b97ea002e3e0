#include "services/coordinator/server/messages/tenant_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::tenant_events_test {
namespace {

constexpr int64_t kSecond = 1'000'000;

class TenantEventsTest : public testing::Test {
 protected:
  void Make(const std::string& id, int64_t time_us, const std::string& tenant = "t") {
    NewJob job;
    job.id = job.action_digest = id;
    job.tenant = tenant;
    ASSERT_TRUE(store_.Create(job, time_us).ok());
  }

  static std::string Reported(TenantEvents& events, int64_t now_us) {
    const auto found = events.Next(now_us);
    EXPECT_TRUE(found.ok()) << found.status();
    std::string text;
    for (const TenantEvent& event : *found) text += event.job_id + " ";
    return text;
  }

  MemoryJobs jobs_;
  MemoryJobStore store_{jobs_};
};

TEST_F(TenantEventsTest, EachIsToldOnceFromTheBeginningOn) {
  Make("old", 99 * kSecond);
  Make("a", 100 * kSecond);
  Make("other", 101 * kSecond, "other");
  TenantEvents events(store_, "t", 100 * kSecond);
  EXPECT_EQ(Reported(events, 101 * kSecond), "a ");
  EXPECT_EQ(Reported(events, 101 * kSecond), "");
  Make("b", 102 * kSecond);
  EXPECT_EQ(Reported(events, 102 * kSecond), "b ");
  EXPECT_EQ(Reported(events, 110 * kSecond), "") << "though it looks back";
}

// The event has an early time because its coordinator's clock is behind. It was committed late.
TEST_F(TenantEventsTest, OneThatIsLateIsToldLate) {
  TenantEvents events(store_, "t", 100 * kSecond);
  Make("a", 140 * kSecond);
  EXPECT_EQ(Reported(events, 140 * kSecond), "a ");
  Make("a little late", 139 * kSecond);
  Make("late", 105 * kSecond);
  EXPECT_EQ(Reported(events, 141 * kSecond), "a little late ");
  EXPECT_EQ(Reported(events, 145 * kSecond), "late ");
  EXPECT_EQ(Reported(events, 155 * kSecond), "");
}

TEST_F(TenantEventsTest, WhoGoesOnFromACursorMissesNothing) {
  TenantEvents events(store_, "t", 0);
  for (int i = 0; i < 300; ++i) Make("j" + std::to_string(i), 1000 * kSecond + i);
  std::string all = Reported(events, 1001 * kSecond);
  EXPECT_TRUE(events.more());
  all += Reported(events, 1001 * kSecond);
  EXPECT_FALSE(events.more());
  EXPECT_EQ(std::count(all.begin(), all.end(), ' '), 300);
  Make("late", 990 * kSecond);
  const auto time_us = TimeOfCursor(events.cursor());
  ASSERT_TRUE(time_us);
  EXPECT_LE(*time_us, 990 * kSecond);
  EXPECT_GT(*time_us, 900 * kSecond);
  TenantEvents again(store_, "t", *time_us);
  EXPECT_TRUE(Reported(again, 1002 * kSecond).starts_with("late j0 ")) << "and some once more";
}

TEST(Cursor, IsATime) {
  EXPECT_EQ(TimeOfCursor("12"), 12);
  for (const char* none : {"", "x", "-1", "1.5"}) EXPECT_FALSE(TimeOfCursor(none)) << none;
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_events_test
