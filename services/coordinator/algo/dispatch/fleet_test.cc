#include "services/coordinator/algo/dispatch/fleet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "common/base/error.h"
#include "common/base/span_log.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"

namespace slicefarm::coordinator::fleet_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

/// Runner that calls the given function in the middle of a range.
class CalledRanges : public FdmRunner {
 public:
  using Work = std::function<absl::StatusOr<FdmResult>(const StageCall&)>;
  explicit CalledRanges(Work work) : work_(std::move(work)) {}

  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask&) const override {
    return work_(call);
  }

 private:
  const Work work_;
};

/// Runner set that only stores the runners. The test runs the ranges.
class KeptRunners : public RunnerSet {
 public:
  RunnerId Join(Runner runner) override {
    runners[++last_] = std::move(runner);
    return last_;
  }
  void Leave(RunnerId id) override { runners.erase(id); }

  std::map<RunnerId, Runner> runners;

 private:
  RunnerId last_ = 0;
};

class FleetTest : public testing::Test {
 protected:
  RunnerId Join(const std::string& name, CalledRanges::Work work) {
    return fleet_.Join(
        {.name = name, .tasks = std::make_shared<CalledRanges>(std::move(work)), .slots = 3});
  }

  absl::Status Run(RunnerId id, LayerRange layers) {
    StageCall call;
    call.job_id = "j1";
    call.trace = TraceOfJob("j1");
    call.spans = &spans_;
    FdmTask task;
    task.range = layers;
    return kept_.runners.at(id).tasks->RunTask(call, task).status();
  }

  KeptRunners kept_;
  Fleet fleet_{kept_};
  SpanLog spans_{0, 100};
};

TEST_F(FleetTest, ShowsWhatIsBeingWorkedOn) {
  std::vector<RunnerAtWork> seen;
  const RunnerId id = Join("w:1", [&](const StageCall&) {
    seen = fleet_.Runners();
    return FdmResult();
  });
  EXPECT_TRUE(Run(id, {8, 16}).ok());
  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_EQ(seen[0].name, "w:1");
  EXPECT_EQ(seen[0].slots, 3);
  ASSERT_THAT(seen[0].tasks, SizeIs(1));
  EXPECT_EQ(seen[0].tasks[0].job_id, "j1");
  EXPECT_EQ(seen[0].tasks[0].task, "layers 8 to 15");
  EXPECT_GE(seen[0].tasks[0].since_s, 0);
  EXPECT_THAT(fleet_.Runners()[0].tasks, IsEmpty());
  fleet_.Leave(id);
  EXPECT_THAT(fleet_.Runners(), IsEmpty());
  EXPECT_THAT(kept_.runners, IsEmpty());
}

TEST_F(FleetTest, EachCallIsASpanOfItsJob) {
  std::vector<TraceContext> traces;
  const RunnerId good = Join("w:1", [&](const StageCall& call) {
    traces.push_back(call.trace);
    FdmResult result;
    result.times[Stage::kInfill] = 0.5;
    return result;
  });
  const RunnerId bad = Join("w:2", [&](const StageCall& call) -> absl::StatusOr<FdmResult> {
    traces.push_back(call.trace);
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "gone");
  });
  EXPECT_FALSE(Run(bad, {0, 8}).ok());
  EXPECT_TRUE(Run(good, {0, 8}).ok());
  EXPECT_TRUE(Run(good, {0, 8}).ok());

  const auto spans = spans_.spans();
  ASSERT_THAT(spans, SizeIs(3));
  EXPECT_EQ(spans[0].name, "layers 0 to 7");
  EXPECT_EQ(spans[0].track, "w:2");
  EXPECT_THAT(spans[0].facts, ElementsAre(Pair("error", "gone"), Pair("outcome", "UNAVAILABLE"),
                                          Pair("span_id", traces[0].span_id)));
  EXPECT_EQ(spans[1].track, "w:1");
  EXPECT_EQ(spans[1].facts.at("outcome"), "ok");
  EXPECT_EQ(spans[1].facts.at("infill_s"), "0.5");
  std::set<std::string> span_ids;
  for (const TraceContext& trace : traces) {
    EXPECT_EQ(trace.trace_id, TraceOfJob("j1").trace_id);
    span_ids.insert(trace.span_id);
  }
  EXPECT_THAT(span_ids, SizeIs(3)) << "calls of the same range are told apart";
}

TEST_F(FleetTest, AMemberThatComesBackHasOtherSpans) {
  std::vector<std::string> span_ids;
  const auto work = [&](const StageCall& call) {
    span_ids.push_back(call.trace.span_id);
    return FdmResult();
  };
  for (int life = 0; life < 2; ++life) {
    const RunnerId id = Join("w:1", work);
    EXPECT_TRUE(Run(id, {0, 8}).ok());
    fleet_.Leave(id);
  }
  EXPECT_NE(span_ids.at(0), span_ids.at(1));
}

TEST_F(FleetTest, ACallMayOutliveItsMembership) {
  RunnerId id = 0;
  id = Join("w:1", [&](const StageCall&) {
    fleet_.Leave(id);
    return FdmResult();
  });
  const Runner runner = kept_.runners.at(id);  // as a slot holds it
  EXPECT_TRUE(runner.tasks->RunTask(StageCall(), FdmTask()).ok());
  EXPECT_THAT(spans_.spans(), IsEmpty());
}

}  // namespace
}  // namespace slicefarm::coordinator::fleet_test
