#include "services/coordinator/algo/job_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator::job_trace_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::SizeIs;

/// Returns the events of one kind: "X" for spans, "M" for names.
std::vector<json> EventsOf(const std::string& chrome, const std::string& phase) {
  std::vector<json> events;
  const json trace = json::parse(chrome);
  for (const json& event : trace["traceEvents"]) {
    if (event["ph"] == phase) events.push_back(event);
  }
  return events;
}

/// Returns the row of each span of a track, in the order in which the spans begin.
std::vector<int> RowsOf(const std::vector<Span>& spans) {
  std::vector<int> rows;
  for (const json& event : EventsOf(ChromeTrace({spans}, {}, {}), "X"))
    rows.push_back(event["tid"]);
  return rows;
}

TEST(JobTrace, IsKeptAsItWas) {
  const JobTrace trace = {
      {{"slicing", "", 10, 20, {{"outcome", "ok"}}}, {"layers 0-7", "w:1", 20, 30}}, 3};
  const auto read = JobTraceFromJson(ToJson(trace));
  ASSERT_TRUE(read.ok()) << read.status();
  EXPECT_EQ(*read, trace);
}

TEST(JobTrace, DamageIsToldAsSuch) {
  const std::string good = ToJson({{{"slicing", "", 10, 20}}, 0});
  for (const std::string& bad :
       {std::string(), std::string("[]"), std::string("{\"spans\":[{}],\"dropped\":0}"),
        std::string("{\"spans\":7,\"dropped\":0}"), good.substr(0, good.size() / 2)}) {
    EXPECT_TRUE(absl::IsDataLoss(JobTraceFromJson(bad).status())) << bad;
  }
}

TEST(JobTrace, TextThatIsNoUtf8IsStillATrace) {
  const JobTrace trace = {{{"\xff", "\xfe", 1, 2, {{"error", "\xc3("}}}}, 0};
  EXPECT_TRUE(JobTraceFromJson(ToJson(trace)).ok());
  EXPECT_THAT(EventsOf(ChromeTrace(trace, {}, {{"job", "\xff"}}), "X"), SizeIs(1));
}

TEST(JobTrace, RunsFollowEachOther) {
  SpanLog run(0, 1);
  for (const char* name : {"second", "lost"}) const ScopedSpan span(&run, name);
  const JobTrace joined = Joined({{{"first", "", 1, 2}}, 5}, run);
  EXPECT_THAT(joined.spans, ElementsAre(testing::Field(&Span::name, "first"),
                                        testing::Field(&Span::name, "second")));
  EXPECT_EQ(joined.dropped, 6);
}

TEST(JobTrace, OfTooManySpansTheLatestAreKept) {
  JobTrace earlier;
  earlier.spans.resize(kMaxJobSpans, {"old", "", 1, 2});
  SpanLog run(0, 10);
  for (int i = 0; i < 3; ++i) const ScopedSpan span(&run, "new");
  const JobTrace joined = Joined(earlier, run);
  EXPECT_THAT(joined.spans, SizeIs(kMaxJobSpans));
  EXPECT_EQ(joined.spans.back().name, "new");
  EXPECT_EQ(joined.dropped, 3);
}

TEST(ChromeTrace, ShowsTheJobAndEachWorker) {
  const JobTrace trace = {{{"slicing", "", 100, 150, {{"meshes", "1"}}},
                           {"layers 0-7", "w:2", 150, 190, {{"outcome", "ok"}}},
                           {"run", "", 90, 200}},
                          2};
  const std::string chrome =
      ChromeTrace(trace, {{"queued", "", 10, 90}}, {{"job", "j1"}, {"trace_id", "abc"}});
  const json all = json::parse(chrome);
  EXPECT_EQ(all["otherData"]["job"], "j1");
  EXPECT_EQ(all["otherData"]["dropped_spans"], "2");

  const auto spans = EventsOf(chrome, "X");
  ASSERT_THAT(spans, SizeIs(4));
  EXPECT_EQ(spans[0]["name"], "queued");
  EXPECT_EQ(spans[1]["name"], "run") << "what encloses others comes first";
  EXPECT_EQ(spans[2]["name"], "slicing");
  EXPECT_EQ(spans[2]["ts"], 100);
  EXPECT_EQ(spans[2]["dur"], 50);
  EXPECT_EQ(spans[2]["args"]["meshes"], "1");
  EXPECT_EQ(spans[1]["tid"], spans[2]["tid"]);
  EXPECT_NE(spans[0]["tid"], spans[1]["tid"]);
  EXPECT_EQ(spans[3]["args"]["outcome"], "ok");
  EXPECT_EQ(spans[3]["args"]["attempt"], 1);
  EXPECT_NE(spans[3]["pid"], spans[2]["pid"]);

  std::map<int, std::string> names;
  for (const json& event : EventsOf(chrome, "M")) {
    if (event["name"] == "process_name") names[event["pid"]] = event["args"]["name"];
  }
  EXPECT_EQ(names[spans[2]["pid"]], "job");
  EXPECT_EQ(names[spans[3]["pid"]], "w:2");
}

TEST(ChromeTrace, AWorkerHasARowForEachThingItDoesAtOnce) {
  EXPECT_THAT(RowsOf({{"a", "w", 0, 10}, {"b", "w", 10, 20}, {"c", "w", 20, 30}}),
              ElementsAre(1, 1, 1));
  EXPECT_THAT(RowsOf({{"a", "w", 0, 10}, {"b", "w", 1, 2}, {"c", "w", 3, 20}, {"d", "w", 11, 12}}),
              ElementsAre(1, 2, 2, 1));
  EXPECT_THAT(RowsOf({{"a", "v", 0, 10}, {"b", "w", 0, 10}}), ElementsAre(1, 1));
}

TEST(ChromeTrace, AttemptsAtTheSameRangeAreNumbered) {
  const JobTrace trace = {{{"layers 0-7", "w:1", 0, 10},
                           {"layers 8-9", "w:2", 0, 50},
                           {"layers 0-7", "w:2", 12, 90},
                           {"layers 0-7", "w:1", 40, 60}},
                          0};
  std::vector<std::pair<int, bool>> attempts;
  for (const json& event : EventsOf(ChromeTrace(trace, {}, {}), "X")) {
    attempts.emplace_back(event["args"]["attempt"], event["args"]["copy"]);
  }
  EXPECT_THAT(attempts, ElementsAre(std::pair(1, false), std::pair(1, false), std::pair(2, false),
                                    std::pair(3, true)));
}

}  // namespace
}  // namespace slicefarm::coordinator::job_trace_test
