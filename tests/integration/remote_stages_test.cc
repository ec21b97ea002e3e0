#include "services/coordinator/remote/remote_stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "common/base/build_info.h"
#include "common/base/error.h"
#include "common/model/options/infill_options.h"
#include "common/rpc/event_test.h"
#include "common/rpc/status_mapping.h"
#include "common/stage/exposure_job.h"
#include "common/stage/memory_budget.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "processes/fdm/task/fdm_shared.h"
#include "slicefarm/v1/beading.grpc.pb.h"
#include "tests/integration/fake_stages.h"
#include "tests/integration/remote_clients.h"
#include "tests/integration/stage_host.h"

namespace slicefarm::remote_stages_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Fakes behind a socket.
struct FakeHost {
  FakeHost(const rpc::CallLimiterOptions& gate, const rpc::ServerOptions& options)
      : host({fake_slicing, fake_beading, fake_infill, fake_ordering, fake_motion, fake_runner,
              [this](rpc::CallLimiter& its) { return std::make_unique<FakePlanning>(fakes, its); },
              &fake_exposure},
             gate, options) {}

  FakeStages fakes;
  FakeSlicing fake_slicing{fakes};
  FakeBeading fake_beading{fakes};
  FakeInfill fake_infill{fakes};
  FakeOrdering fake_ordering{fakes};
  FakeMotion fake_motion{fakes};
  FakeExposure fake_exposure{fakes};
  FakeRunner fake_runner{fakes};
  StageHost host;
};

/// Fakes behind a socket, with clients for them.
struct Farm : FakeHost, RemoteClients {
  explicit Farm(const rpc::CallLimiterOptions& gate = {4, 0},
                const rpc::ServerOptions& options = {}, milliseconds deadline = seconds(60))
      : FakeHost(gate, options), RemoteClients(host.Address(), {deadline}) {}
};

StageCall NewCall() {
  StageCall call;
  call.job_id = "job-42";
  return call;
}

Neighbourhood TheNeighbourhood() { return {Sample::kRange, TheSample().outlines}; }

SlicedOutlines TheOutlines() { return {TheSample().job.layers, TheSample().job.copies}; }

FdmTask TheTask() {
  const Sample& sample = TheSample();
  return {Sample::kRange, sample.outlines, sample.plans,
          FdmShared{FdmOf(sample.settings), sample.plan.copies, sample.facts}};
}

TEST(RemoteStages, SlicingGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto job = farm.slicing.Slice(NewCall(), sample.input, sample.settings.slicing);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->layers, sample.job.layers);
  EXPECT_EQ(job->object_names, sample.job.object_names);
  EXPECT_EQ(job->copies, sample.job.copies);
  EXPECT_EQ(job->meshes, sample.job.meshes);
  EXPECT_EQ(job->thumbnails, sample.job.thumbnails);
  ASSERT_EQ(farm.fakes.slice_input.files.size(), 3);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(farm.fakes.slice_input.files[i].name, sample.input.files[i].name);
    EXPECT_EQ(farm.fakes.slice_input.files[i].format, sample.input.files[i].format);
    EXPECT_EQ(farm.fakes.slice_input.files[i].bytes, sample.input.files[i].bytes);
  }
  EXPECT_TRUE(farm.fakes.slice_input.objects == sample.input.objects);
  EXPECT_EQ(farm.fakes.slicing_options, sample.settings.slicing);
  EXPECT_EQ(farm.fakes.call.job_id, "job-42");
  EXPECT_EQ(farm.fakes.call.threads, StageHost::kThreads);
}

TEST(RemoteStages, PlanningGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto plan =
      farm.planning.Plan(NewCall(), TheOutlines(), PlanningOf(FdmOf(sample.settings)));
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_EQ(*plan, sample.plan);
  EXPECT_EQ(farm.fakes.layers, sample.job.layers);
  EXPECT_EQ(farm.fakes.placed, sample.job.copies);
  EXPECT_EQ(farm.fakes.planning_options, PlanningOf(FdmOf(sample.settings)));
  EXPECT_EQ(farm.fakes.call.job_id, "job-42");
}

// The memory is reserved as the data arrives. A lack of memory does not count as the stage's fault.
TEST(RemoteStages, OutlinesAndPlansAreHeldInTheJobsMemory) {
  Farm farm;
  const Sample& sample = TheSample();
  int64_t outlines = 0;
  for (const SlicedLayer& layer : sample.job.layers) outlines += MemoryOf(layer);
  int64_t plan = 0;
  for (const LayerPlan& layer : sample.plan.layers) plan += MemoryOf(layer);
  for (const AddedStack& added : sample.plan.stacks)
    for (const ObjectSection& section : added.sections) plan += MemoryOf(section);
  plan += MemoryOf(sample.plan.skirt);
  for (const int64_t limit : {outlines + plan, outlines + plan - 1, outlines - 1}) {
    MemoryBudget budget(limit);
    const auto share = budget.Take({}, "job-42", 0, {});
    ASSERT_TRUE(share.ok());
    StageCall call = NewCall();
    call.memory = share->get();
    absl::Status status = farm.slicing.Slice(call, sample.input, sample.settings.slicing).status();
    EXPECT_EQ(status.ok(), limit >= outlines) << status;
    if (status.ok()) {
      EXPECT_EQ(budget.used(), outlines);
      status = farm.planning.Plan(call, TheOutlines(), PlanningOf(FdmOf(sample.settings))).status();
      EXPECT_EQ(status.ok(), limit >= outlines + plan) << status;
    }
    if (status.ok()) continue;
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
    EXPECT_EQ(DetailOf(status).metadata.at("limit"), std::to_string(limit));
  }
}

TEST(RemoteStages, BeadingGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto walled =
      farm.beading.Bead(NewCall(), TheNeighbourhood(), BeadingOf(FdmOf(sample.settings)));
  ASSERT_TRUE(walled.ok()) << walled.status();
  EXPECT_EQ(*walled, sample.walled);
  EXPECT_EQ(farm.fakes.range, Sample::kRange);
  EXPECT_EQ(farm.fakes.layers, sample.outlines);
  EXPECT_EQ(farm.fakes.beading_options, BeadingOf(FdmOf(sample.settings)));
  EXPECT_EQ(farm.fakes.call.job_id, "job-42");
}

TEST(RemoteStages, InfillGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto filled = farm.infill.Fill(NewCall(), sample.walled, TheNeighbourhood(), sample.plans,
                                       InfillOf(FdmOf(sample.settings)));
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(*filled, sample.filled);
  EXPECT_EQ(farm.fakes.range, Sample::kRange);
  EXPECT_EQ(farm.fakes.layers, sample.outlines);
  EXPECT_EQ(farm.fakes.walled, sample.walled);
  EXPECT_EQ(farm.fakes.infill_options, InfillOf(FdmOf(sample.settings)));
  ASSERT_EQ(farm.fakes.infill_plans.size(), sample.plans.size());
  for (size_t i = 0; i < sample.plans.size(); ++i)
    EXPECT_EQ(farm.fakes.infill_plans[i].infill, sample.plans[i].infill);
}

TEST(RemoteStages, OrderingGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto ordered =
      farm.ordering.Order(NewCall(), sample.filled, sample.plans,
                          OrderingJob{OrderingOf(FdmOf(sample.settings)), sample.plan.copies});
  ASSERT_TRUE(ordered.ok()) << ordered.status();
  EXPECT_EQ(*ordered, sample.ordered);
  EXPECT_EQ(farm.fakes.filled, sample.filled);
  std::vector<LayerPlan> plans = sample.plans;
  for (LayerPlan& plan : plans) plan.infill.clear();  // infill is already filled
  EXPECT_EQ(farm.fakes.plans, plans);
  EXPECT_EQ(farm.fakes.copies, sample.plan.copies);
  EXPECT_EQ(farm.fakes.ordering_options, OrderingOf(FdmOf(sample.settings)));
}

TEST(RemoteStages, MotionGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto programs = farm.motion.Program(
      NewCall(), sample.ordered, MotionJob{MotionOf(FdmOf(sample.settings)), sample.facts});
  ASSERT_TRUE(programs.ok()) << programs.status();
  EXPECT_EQ(*programs, sample.programs);
  EXPECT_EQ(farm.fakes.ordered, sample.ordered);
  EXPECT_EQ(farm.fakes.facts, sample.facts);
  EXPECT_EQ(farm.fakes.motion_options, MotionOf(FdmOf(sample.settings)));
}

TEST(RemoteStages, FrameGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto frame =
      farm.motion.Envelope(NewCall(), sample.summary, MotionOf(FdmOf(sample.settings)));
  ASSERT_TRUE(frame.ok()) << frame.status();
  EXPECT_EQ(*frame, sample.frame);
  EXPECT_EQ(farm.fakes.summary, sample.summary);
  EXPECT_EQ(farm.fakes.motion_options, MotionOf(FdmOf(sample.settings)));
  EXPECT_EQ(farm.fakes.call.job_id, "job-42");
}

TEST(RemoteStages, WorkerGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto result = RunFdm(farm.worker, NewCall(), TheTask());
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_EQ(result->programs, sample.programs);
  EXPECT_EQ(result->warnings, sample.warnings);
  EXPECT_EQ(result->fills, sample.fills);
  EXPECT_EQ(result->times[Stage::kBeading], sample.times[Stage::kBeading]);
  EXPECT_EQ(result->times[Stage::kMotion], sample.times[Stage::kMotion]);
  EXPECT_EQ(farm.fakes.range, Sample::kRange);
  EXPECT_EQ(farm.fakes.layers, sample.outlines);
  EXPECT_EQ(farm.fakes.plans, sample.plans);
  EXPECT_EQ(farm.fakes.copies, sample.plan.copies);
  EXPECT_EQ(farm.fakes.facts, sample.facts);
  EXPECT_EQ(farm.fakes.fdm_settings, FdmOf(sample.settings));
  EXPECT_EQ(farm.fakes.call.job_id, "job-42");
}

// Shared data is sent once, for any number of uses and of copies.
TEST(RemoteStages, WhatAJobsCallsShareIsSentOnce) {
  Farm farm;
  const Sample& sample = TheSample();
  const Shared<InfillTable> table = InfillOf(FdmOf(sample.settings));
  for (int i = 0; i < 3; ++i) {
    const Shared<InfillTable> copy = table;  // NOLINT(performance-unnecessary-copy-initialization)
    const auto filled =
        farm.infill.Fill(NewCall(), sample.walled, TheNeighbourhood(), sample.plans, copy);
    ASSERT_TRUE(filled.ok()) << filled.status();
  }
  EXPECT_EQ(farm.host.shared().counts().misses, 1);
  EXPECT_EQ(farm.host.shared().counts().hits, 3);
  ASSERT_TRUE(RunFdm(farm.worker, NewCall(), TheTask()).ok());
  ASSERT_TRUE(RunFdm(farm.worker, NewCall(), TheTask()).ok()) << "an equal one, made anew";
  EXPECT_EQ(farm.host.shared().counts().misses, 2);
  EXPECT_EQ(farm.host.shared().counts().entries, 2);
}

/// Test case for every call of every stage.
struct AnyCall {
  std::string name;
  std::function<absl::Status(const Farm&, const StageCall&)> make;
  bool answers_layers = true;
};

class EveryRemoteCall : public testing::TestWithParam<AnyCall> {
 protected:
  static absl::Status Make(const Farm& farm, const StageCall& call = NewCall()) {
    return GetParam().make(farm, call);
  }
};

INSTANTIATE_TEST_SUITE_P(
    Stages, EveryRemoteCall,
    testing::Values(
        AnyCall{"Slice",
                [](const Farm& farm, const StageCall& call) {
                  return farm.slicing.Slice(call, TheSample().input, {}).status();
                },
                false},
        AnyCall{"Plan",
                [](const Farm& farm, const StageCall& call) {
                  return farm.planning.Plan(call, TheOutlines(), {}).status();
                }},
        AnyCall{"Bead",
                [](const Farm& farm, const StageCall& call) {
                  return farm.beading
                      .Bead(call, TheNeighbourhood(), BeadingOf(FdmOf(TheSample().settings)))
                      .status();
                }},
        AnyCall{"Fill",
                [](const Farm& farm, const StageCall& call) {
                  const Sample& sample = TheSample();
                  return farm.infill
                      .Fill(call, sample.walled, TheNeighbourhood(), sample.plans,
                            InfillOf(FdmOf(sample.settings)))
                      .status();
                }},
        AnyCall{"Order",
                [](const Farm& farm, const StageCall& call) {
                  const Sample& sample = TheSample();
                  return farm.ordering
                      .Order(call, sample.filled, sample.plans, OrderingJob{{}, sample.plan.copies})
                      .status();
                }},
        AnyCall{"Program",
                [](const Farm& farm, const StageCall& call) {
                  const Sample& sample = TheSample();
                  return farm.motion.Program(call, sample.ordered, MotionJob{{}, sample.facts})
                      .status();
                }},
        AnyCall{"Frame",
                [](const Farm& farm, const StageCall& call) {
                  return farm.motion.Envelope(call, TheSample().summary, {}).status();
                },
                false},
        AnyCall{"Expose",
                [](const Farm& farm, const StageCall& call) {
                  const Sample& sample = TheSample();
                  return farm.exposure
                      .Expose(call, TheNeighbourhood(),
                              ExposureJob{sample.exposure_settings, sample.plan.copies})
                      .status();
                }},
        AnyCall{"FrameExposure",
                [](const Farm& farm, const StageCall& call) {
                  return farm.exposure.Envelope(call, {}, TheSample().exposure_settings).status();
                },
                false},
        AnyCall{"Work",
                [](const Farm& farm, const StageCall& call) {
                  return RunFdm(farm.worker, call, TheTask()).status();
                }}),
    [](const auto& info) { return info.param.name; });

TEST(RemoteStages, ExposureGivesAndTakesAll) {
  Farm farm;
  const Sample& sample = TheSample();
  const auto programs = farm.exposure.Expose(
      NewCall(), TheNeighbourhood(), ExposureJob{sample.exposure_settings, sample.plan.copies});
  ASSERT_TRUE(programs.ok()) << programs.status();
  EXPECT_EQ(*programs, sample.exposed);
  EXPECT_EQ(farm.fakes.range, Sample::kRange);
  EXPECT_EQ(farm.fakes.layers, sample.outlines);
  EXPECT_EQ(farm.fakes.copies, sample.plan.copies);
  EXPECT_EQ(farm.fakes.exposure, sample.exposure_settings);
  const ExposureSummary summary{{{0, 5, 5}}, {{1, 2}, {3, 4}}, {"a"}, 6, "contours = 1\n"};
  const auto frame = farm.exposure.Envelope(NewCall(), summary, sample.exposure_settings);
  ASSERT_TRUE(frame.ok()) << frame.status();
  EXPECT_EQ(frame->header, "header");
  EXPECT_EQ(farm.fakes.exposure_summary, summary);
}

TEST_P(EveryRemoteCall, BringsTheStagesErrorWithItsReason) {
  Farm farm;
  farm.fakes.before = [](const StageCall&) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange, "too wide",
                     {{"setting", "perimeter_extrusion_width"}});
  };
  const absl::Status status = Make(farm);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(status.message(), "too wide");
  EXPECT_EQ(DetailOf(status).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["setting"], "perimeter_extrusion_width");
}

TEST_P(EveryRemoteCall, CancellationReachesTheAlgorithm) {
  Farm farm;
  Event begun;
  Event stopped;
  farm.fakes.before = [&](const StageCall& call) {
    begun.Happen();
    while (!call.cancel.Cancelled()) std::this_thread::yield();
    stopped.Happen();
    return call.cancel.Check();
  };
  StageCall call = NewCall();
  call.cancel = CancelToken([&] { return begun.Happened(); });
  const absl::Status status = Make(farm, call);
  ASSERT_TRUE(begun.Happened()) << status;
  EXPECT_TRUE(absl::IsCancelled(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kCancelled);
  stopped.Await();
}

TEST_P(EveryRemoteCall, AServerThatDoesNotAnswerInTimeIsAway) {
  Farm farm({4, 0}, {}, milliseconds(100));
  // The deadline may pass before the call arrives here. The farm's destructor waits for the call in
  // this case.
  farm.fakes.before = [](const StageCall& call) {
    while (!call.cancel.Cancelled()) std::this_thread::yield();
    return call.cancel.Check();
  };
  const absl::Status status = Make(farm);
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("did not answer within"));
}

TEST_P(EveryRemoteCall, AServerThatGoesAwayIsUnavailable) {
  Farm farm;
  Event begun;
  farm.fakes.before = [&](const StageCall& call) {
    begun.Happen();
    while (!call.cancel.Cancelled()) std::this_thread::yield();
    return call.cancel.Check();
  };
  std::thread stop([&] {
    begun.Await();
    farm.host.server().Drain(milliseconds(0));
  });
  const absl::Status status = Make(farm);
  begun.Happen();  // ends the wait if the call failed earlier
  stop.join();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kUnavailable);
}

TEST_P(EveryRemoteCall, AnAnswerThatLacksALayerIsNotTheInputsFault) {
  if (!GetParam().answers_layers) return;
  Farm farm;
  farm.fakes.lose_a_layer = true;
  EXPECT_EQ(Make(farm).code(), absl::StatusCode::kInternal);
}

TEST_P(EveryRemoteCall, MessagesBeyondTheLimitNameIt) {
  rpc::ServerOptions options;
  options.max_message_bytes = 100;
  Farm farm({4, 0}, options);
  const absl::Status status = Make(farm);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("100"));
}

TEST_P(EveryRemoteCall, WaitsForAServerThatIsFull) {
  Farm farm({1, 0});
  Event begun;
  Event go_on;
  farm.fakes.before = [&](const StageCall&) {
    begun.Happen();
    go_on.Await();
    return absl::OkStatus();
  };
  std::thread first([&] { EXPECT_TRUE(Make(farm).ok()); });
  begun.Await();
  int polls = 0;  // polls of the second call's token while the call is refused
  StageCall call = NewCall();
  call.cancel = CancelToken([&] {
    if (++polls == 20) go_on.Happen();
    return false;
  });
  EXPECT_TRUE(Make(farm, call).ok());
  first.join();
}

// A coordinator of another build would combine layers that do not fit together.
TEST(StageServices, RefuseCallersOfAnotherBuild) {
  Farm farm;
  const auto stub = v1::Beading::NewStub(farm.replica.channel());
  grpc::ClientContext context;
  const auto stream = stub->BeadLayers(&context);
  v1::BeadRequest request;
  request.mutable_start()->mutable_call()->set_build_id("0123456789abcdef");
  stream->Write(request);
  stream->WritesDone();
  const absl::Status status = rpc::FromGrpc(stream->Finish());
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_EQ(DetailOf(status).reason, Reason::kBuildMismatch);
  EXPECT_EQ(DetailOf(status).metadata["callee"], BuildId());
}

TEST(StageServices, RefuseStreamsThatDoNotBeginWithStart) {
  Farm farm;
  const auto stub = v1::Beading::NewStub(farm.replica.channel());
  for (const bool layer_first : {false, true}) {
    grpc::ClientContext context;
    const auto stream = stub->BeadLayers(&context);
    v1::BeadRequest request;
    request.mutable_layer();
    if (layer_first) stream->Write(request);
    stream->WritesDone();
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_EQ(DetailOf(status).metadata["field"], "start");
  }
}

TEST(StageServices, NameTheFieldOfALayerThatIsMalformed) {
  Farm farm;
  std::vector<SlicedLayer> outlines = TheSample().outlines;
  outlines[2].frame.height_nm = 0;
  const absl::Status status =
      farm.beading
          .Bead(NewCall(), {Sample::kRange, outlines}, BeadingOf(FdmOf(TheSample().settings)))
          .status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata["field"], "message[2].frame.height_nm");
}

// Rows of settings and objects are addressed by index, so a table that is too short is a caller's
// error.
TEST(StageServices, RefuseACallWithoutSettingsOfAnyRegion) {
  Farm farm;
  const absl::Status status = farm.beading.Bead(NewCall(), TheNeighbourhood(), {}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata["field"], "start.shared.rows.walls");
}

TEST(StageServices, RefuseAPlateWithoutRegions) {
  Farm farm;
  FdmTask task = TheTask();
  FdmShared job = *task.job;
  job.settings.regions.clear();
  task.job = job;
  EXPECT_EQ(DetailOf(RunFdm(farm.worker, NewCall(), task).status()).reason,
            Reason::kRequestMalformed);
}

TEST(RemoteStages, AnInputBeyondTheWireIsRefusedBeforeItIsSent) {
  Farm farm;
  std::vector<SlicedLayer> outlines = TheSample().outlines;
  outlines[1].sections[1].regions[0].outlines[0].outer[0].x = Coord{1} << 31;
  const absl::Status status =
      farm.beading
          .Bead(NewCall(), {Sample::kRange, outlines}, BeadingOf(FdmOf(TheSample().settings)))
          .status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange) << status;
}

}  // namespace
}  // namespace slicefarm::remote_stages_test
