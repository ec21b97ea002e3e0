// Tests of the stored and downloaded traces of jobs, with a real server, real stores and fake
// stages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "common/base/error.h"
#include "nlohmann/json.hpp"
#include "services/coordinator/server/main/coordinator_fixture_test.h"
#include "services/coordinator/server/observe/metric_values_test.h"

namespace slicefarm::coordinator::job_trace_end_to_end_test {
namespace {

using nlohmann::json;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::SizeIs;

constexpr char kGiven[] = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";

class JobTraceTest : public CoordinatorTest {
 protected:
  json Trace(const std::string& id) {
    const auto text = Download(id, v1::ARTIFACT_TRACE);
    EXPECT_TRUE(text.ok()) << text.status();
    return text.ok() ? json::parse(*text) : json();
  }

  /// Returns the spans with one name; all spans if the name is empty.
  static std::vector<json> Spans(const json& trace, const std::string& name = "") {
    std::vector<json> spans;
    for (const json& event : trace["traceEvents"]) {
      if (event["ph"] == "X" && (name.empty() || event["name"] == name)) spans.push_back(event);
    }
    return spans;
  }

  static std::set<std::string> Names(const json& trace) {
    std::set<std::string> names;
    for (const json& span : Spans(trace)) names.insert(span["name"]);
    return names;
  }

  std::string SubmitTraced(const std::string& mesh) {
    EXPECT_TRUE(Upload(mesh).ok());
    return Create(RequestFor(mesh), *ParseTraceparent(kGiven))->id();
  }

  void RemoveBlobs() {
    std::filesystem::remove_all(directory_.path() + "/blobs");
    std::filesystem::create_directory(directory_.path() + "/blobs");
  }
};

TEST_F(JobTraceTest, AJobBelongsToTheTraceOfItsCall) {
  const std::string id = SubmitTraced("xxx");
  EXPECT_EQ(coordinator_->jobs().Get(id)->traceparent, kGiven);
  AwaitEnd(id);
  ASSERT_THAT(slicing_.traces(), SizeIs(1));
  EXPECT_EQ(slicing_.traces()[0].trace_id, ParseTraceparent(kGiven)->trace_id);
  EXPECT_NE(slicing_.traces()[0].span_id, ParseTraceparent(kGiven)->span_id);
  EXPECT_EQ(Trace(id)["otherData"]["trace_id"], ParseTraceparent(kGiven)->trace_id);
}

TEST_F(JobTraceTest, AJobWithoutATraceGetsItsOwn) {
  const std::string id = Submit("xxx");
  EXPECT_EQ(coordinator_->jobs().Get(id)->traceparent, Traceparent(TraceOfJob(id)));
  AwaitEnd(id);
  EXPECT_EQ(slicing_.traces()[0].trace_id, id);
}

TEST_F(JobTraceTest, ARetryGoesOnInTheSameTrace) {
  slicing_.unavailable_ = 1;
  const std::string id = SubmitTraced("x~");
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  const auto traces = slicing_.traces();
  ASSERT_THAT(traces, SizeIs(2));
  EXPECT_EQ(traces[0].trace_id, traces[1].trace_id);
  EXPECT_NE(traces[0].span_id, traces[1].span_id);

  const json trace = Trace(id);
  const auto runs = Spans(trace, "run");
  ASSERT_THAT(runs, SizeIs(2));
  EXPECT_EQ(runs[0]["args"]["outcome"], "UNAVAILABLE");
  EXPECT_EQ(runs[1]["args"]["outcome"], "ok");
  EXPECT_NE(runs[0]["args"]["epoch"], runs[1]["args"]["epoch"]);
  EXPECT_GE(runs[1]["ts"], runs[0]["ts"].get<int64_t>() + runs[0]["dur"].get<int64_t>());
  EXPECT_THAT(Spans(trace, "queued"), SizeIs(2));
  EXPECT_THAT(Spans(trace, "slicing"), SizeIs(2));
}

TEST_F(JobTraceTest, TellsWhereTheTimeWent) {
  const std::string id = Submit("xxx");
  AwaitEnd(id);
  const json trace = Trace(id);
  EXPECT_EQ(trace["otherData"]["job"], id);
  EXPECT_EQ(trace["otherData"]["state"], "SUCCEEDED");
  EXPECT_EQ(trace["otherData"]["cached"], "false");
  EXPECT_THAT(Names(trace), IsSupersetOf({"queued", "run", "cache", "meshes", "slicing", "planning",
                                          "ranges", "frame", "assembly", "artifacts"}));
  const json run = Spans(trace, "run").at(0);
  EXPECT_EQ(run["args"]["coordinator"], "coordinator");
  const auto run_begin = run["ts"].get<int64_t>();
  const auto run_end = run_begin + run["dur"].get<int64_t>();
  for (const json& span : Spans(trace)) {
    if (span["name"] == "queued") continue;
    EXPECT_GE(span["ts"].get<int64_t>(), run_begin) << span;
    EXPECT_LE(span["ts"].get<int64_t>() + span["dur"].get<int64_t>(), run_end) << span;
  }
  int layers = 0;
  for (const json& span : Spans(trace)) {
    if (!span["name"].get<std::string>().starts_with("layers ")) continue;
    EXPECT_EQ(span["args"]["outcome"], "ok");
    EXPECT_EQ(span["args"]["attempt"], 1);
    ++layers;
  }
  EXPECT_GT(layers, 0);
  EXPECT_EQ(Spans(trace, "ranges").at(0)["args"]["ranges"], std::to_string(layers));
}

TEST_F(JobTraceTest, FailedJobsHaveATraceToo) {
  const std::string id = Submit("x!");
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_FAILED);
  const json trace = Trace(id);
  EXPECT_EQ(trace["otherData"]["reason"], "MESH_MALFORMED");
  EXPECT_EQ(Spans(trace, "run").at(0)["args"]["outcome"], "MESH_MALFORMED");
  EXPECT_THAT(Spans(trace, "slicing"), SizeIs(1));
  EXPECT_THAT(Spans(trace, "ranges"), IsEmpty());
}

TEST_F(JobTraceTest, ATraceOutlivesTheCoordinator) {
  const std::string id = Submit("xxx");
  AwaitEnd(id);
  const json before = Trace(id);
  Close();
  Open();
  EXPECT_EQ(Trace(id), before);
}

TEST_F(JobTraceTest, OfACachedJobThereIsTheWaiting) {
  AwaitEnd(Submit("xxx"));
  const std::string id = Submit("xxx");
  AwaitEnd(id);
  const json trace = Trace(id);
  EXPECT_EQ(trace["otherData"]["cached"], "true");
  EXPECT_THAT(Spans(trace), SizeIs(1));
  EXPECT_THAT(Spans(trace, "queued"), SizeIs(1));
}

TEST_F(JobTraceTest, AJobThatHasNotEndedHasNone) {
  ranges_->Hold();
  const std::string id = Submit("xxx");
  ranges_->AwaitCall();
  EXPECT_EQ(DetailOf(Download(id, v1::ARTIFACT_TRACE).status()).reason, Reason::kJobNotFinished);
  ranges_->LetGo();
  AwaitEnd(id);
  EXPECT_TRUE(Download(id, v1::ARTIFACT_TRACE).ok());
}

TEST_F(JobTraceTest, ALostTraceIsAnErrorOfItsOwn) {
  const std::string id = Submit("xxx");
  AwaitEnd(id);
  RemoveBlobs();
  EXPECT_EQ(DetailOf(Download(id, v1::ARTIFACT_TRACE).status()).reason, Reason::kBlobNotFound);
}

TEST_F(JobTraceTest, ALostTraceOfAnEarlierRunCostsNothingElse) {
  slicing_.unavailable_ = 1;
  ranges_->Hold();  // keeps the second run from ending too early
  EXPECT_TRUE(Upload("x~").ok());
  const std::string id = Create(RequestFor("x~"))->id();
  while (coordinator_->jobs().Get(id)->trace_sha256.empty()) std::this_thread::yield();
  const std::string trace = coordinator_->jobs().Get(id)->trace_sha256;
  std::filesystem::remove(directory_.path() + "/blobs/" + trace.substr(0, 2) + "/" + trace);
  ranges_->LetGo();
  EXPECT_EQ(AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_THAT(Spans(Trace(id), "run"), SizeIs(1));
}

TEST_F(JobTraceTest, WhatTheStagesTookIsCounted) {
  const auto count = [&](const char* stage) {
    return MetricValue(registry_.Collect(), "slicefarm_stage_seconds", {{"stage", stage}});
  };
  EXPECT_EQ(count("slicing"), 0);
  AwaitEnd(Submit("xxx"));
  AwaitEnd(Submit("xxx"));  // a cached result
  for (const char* stage : {"slicing", "beading", "infill", "ordering", "motion"}) {
    EXPECT_EQ(count(stage), 1) << stage;
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::job_trace_end_to_end_test
