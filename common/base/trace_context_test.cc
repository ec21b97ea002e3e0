#include "common/base/trace_context.h"

#include <gtest/gtest.h>

#include <set>

namespace slicefarm::trace_context_test {
namespace {

constexpr char kTrace[] = "4bf92f3577b34da6a3ce929d0e0e4736";
constexpr char kSpan[] = "00f067aa0ba902b7";
const std::string kGiven = std::string("00-") + kTrace + "-" + kSpan + "-01";

TEST(TraceContext, IsReadFromAHeader) {
  const auto context = ParseTraceparent(kGiven);
  ASSERT_TRUE(context);
  EXPECT_EQ(*context, (TraceContext{kTrace, kSpan, true}));
  EXPECT_EQ(Traceparent(*context), kGiven);
}

TEST(TraceContext, OnlyTheSampledFlagIsPassedOn) {
  const std::string given = kGiven.substr(0, kGiven.size() - 3);
  EXPECT_EQ(Traceparent(*ParseTraceparent(given + "-00")), given + "-00");
  EXPECT_EQ(Traceparent(*ParseTraceparent(given + "-ff")), given + "-01");
  EXPECT_EQ(Traceparent(*ParseTraceparent(given + "-02")), given + "-00");
}

TEST(TraceContext, VersionsToComeMaySayMore) {
  const std::string later = "cc" + kGiven.substr(2);
  EXPECT_TRUE(ParseTraceparent(later));
  EXPECT_TRUE(ParseTraceparent(later + "-what-the-future-will-be-like"));
  EXPECT_FALSE(ParseTraceparent(later + ".what"));
}

TEST(TraceContext, WhatIsNoneIsIgnored) {
  const std::string zeros(32, '0');
  const std::string trace = kTrace, span = kSpan;
  for (const std::string& text :
       {std::string(), std::string("00"), kGiven.substr(1), kGiven + "-", kGiven + "0",
        "ff-" + trace + "-" + span + "-01", "0g-" + trace + "-" + span + "-01",
        "00-" + zeros + "-" + span + "-01", "00-" + trace + "-" + zeros.substr(16) + "-01",
        "00-" + trace + "-" + span + "-0G", "00_" + trace + "-" + span + "-01",
        "00-" + trace + "_" + span + "-01", "00-" + trace + "-" + span + "_01",
        "00-4BF92F3577B34DA6A3CE929D0E0E4736-" + span + "-01"}) {
    EXPECT_FALSE(ParseTraceparent(text)) << text;
  }
}

TEST(TraceContext, AJobIsItsOwnTrace) {
  EXPECT_EQ(TraceOfJob(kTrace).trace_id, kTrace);
  for (const char* job : {kTrace, "j1", "", "00000000000000000000000000000000"}) {
    const TraceContext context = TraceOfJob(job);
    EXPECT_EQ(ParseTraceparent(Traceparent(context)), context) << job;
    EXPECT_EQ(TraceOfJob(job), context);
  }
  EXPECT_NE(TraceOfJob("j1").trace_id, TraceOfJob("j2").trace_id);
}

TEST(TraceContext, ChildrenAreOtherSpansOfTheSameTrace) {
  const TraceContext parent = TraceOfJob(kTrace);
  std::set<std::string> ids = {parent.span_id};
  for (const char* what : {"a", "b", ""}) {
    const TraceContext child = ChildSpan(parent, what);
    EXPECT_EQ(ParseTraceparent(Traceparent(child)), child);
    EXPECT_EQ(child.trace_id, parent.trace_id);
    ids.insert(child.span_id);
    ids.insert(ChildSpan(child, "a").span_id);
  }
  EXPECT_EQ(ids.size(), 7);
  EXPECT_EQ(ChildSpan(parent, "a"), ChildSpan(parent, "a"));
  EXPECT_TRUE(ChildSpan({}, "a").empty());
  EXPECT_FALSE(ChildSpan({kTrace, kSpan, false}, "a").sampled);
}

}  // namespace
}  // namespace slicefarm::trace_context_test
