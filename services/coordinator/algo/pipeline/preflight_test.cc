#include "services/coordinator/algo/pipeline/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/stage/motion_job.h"
#include "processes/fdm/job/fdm_process.h"
#include "processes/fdm/task/fdm_task.h"

namespace slicefarm::coordinator::preflight_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Slicing stage that returns copies of one object: `layers` squares of 10 mm, and above them
/// layers without outlines.
class FakeSlicing : public SlicingStage {
 public:
  explicit FakeSlicing(int layers, int copies = 1) : layers_(layers), copies_(copies) {}

  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override {
    EXPECT_EQ(options.first_layer_height_nm, 123);
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    SlicedJob job;
    for (int i = 0; i < 10; ++i) {
      SlicedLayer layer{{i, FromMm(0.2 * (i + 1)), FromMm(0.2)}, {}};
      ObjectSection section;
      section.layer = i;
      section.layer_count = 10;
      section.height_nm = layer.frame.height_nm;
      if (i < layers_)
        section.regions = {{.outlines = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")}};
      layer.sections = {section};
      job.layers.push_back(layer);
    }
    job.copies.resize(copies_);
    job.object_names = {"part"};
    job.meshes.resize(1);
    job.meshes[0].open_edges = 4;
    if (input.advise_orientations) job.orientations.resize(1);
    return job;
  }

 private:
  const int layers_;
  const int copies_;
};

/// Planning stage that prints each copy in a pass of its own, or refuses the job.
class FakePlanning : public PlanningStage {
 public:
  absl::StatusOr<JobPlan> Plan(const StageCall&, const SlicedOutlines& job,
                               const PlanningOptions&) const override {
    if (refuses) return absl::InvalidArgumentError("no order");
    JobPlan plan;
    plan.layers.resize(job.layers.size());
    for (const PlacedCopy& copy : job.copies)
      plan.copies.push_back({copy.object, copy.shift, static_cast<int32_t>(plan.copies.size())});
    return plan;
  }

  bool refuses = false;
};

JobInput Input() {
  JobInput input;
  input.settings.slicing.first_layer_height_nm = 123;
  input.warnings = {"of a setting"};
  return input;
}

/// Executor that returns layers of 3 s and 5 mm.
class FakeRunners : public TaskExecutor {
 public:
  absl::Status Execute(const StageCall&, std::span<const Task> tasks, const TakeResult& take,
                       const std::function<void(int32_t)>&) override {
    for (size_t i = 0; i < tasks.size(); ++i) {
      const FdmTask& range = tasks[i].As<FdmTask>();
      EXPECT_EQ(range.range.size(), 1);
      EXPECT_EQ(range.plans.size(), 1u);
      LayerProgram program;
      program.frame.index = range.range.first;
      program.stats.features[0].time_s = 3;
      program.stats.features[0].filament_mm = 5;
      FdmResult result;
      result.programs = {program};
      if (absl::Status taken = take(i, std::move(result)); !taken.ok()) return taken;
      ++made;
    }
    return absl::OkStatus();
  }
  int Slots(Process) const override { return slots; }

  int slots = 4;
  int made = 0;
};

/// Motion stage that adds 100 s before the layers.
class FakeMotion : public MotionStage {
 public:
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall&, std::vector<OrderedLayer>,
                                                    const Shared<MotionJob>&) const override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall&, const ProgramSummary& summary,
                                           const MotionOptions&) const override {
    EXPECT_EQ(summary.settings_text, "text");
    ProgramEnvelope envelope;
    envelope.times.custom_s = 100;
    for (const LayerSummary& layer : summary.layers) envelope.times.feature_s[0] += layer.time_s;
    return envelope;
  }
};

/// Calls LookAt with the FDM process and these stages.
absl::StatusOr<Preflight> Look(const StageCall& call, JobInput input, const SlicingStage& slicing,
                               const PlanningStage& planning, FakeRunners& runners) {
  const FakeMotion motion;
  std::vector<std::unique_ptr<JobProcess>> processes;
  processes.push_back(std::make_unique<FdmProcess>(slicing, planning, motion));
  return LookAt(call, std::move(input), slicing, JobPipeline(std::move(processes), runners));
}

/// Calls LookAt without slots for layers.
absl::StatusOr<Preflight> Look(const StageCall& call, JobInput input, const SlicingStage& slicing,
                               const PlanningStage& planning) {
  FakeRunners none;
  none.slots = 0;
  return Look(call, std::move(input), slicing, planning, none);
}

TEST(LookAt, TellsWhatThePlateIsLike) {
  const auto found = Look({}, Input(), FakeSlicing(10), FakePlanning());
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(found->layers, 10);
  EXPECT_DOUBLE_EQ(found->first_layer_area_mm2, 100);
  EXPECT_EQ(found->meshes.size(), 1);
  EXPECT_THAT(found->warnings,
              ElementsAre("of a setting", HasSubstr("4 edges with one face only")));
  EXPECT_GT(found->print_time_s, 0);
  EXPECT_NEAR(found->filament.volume_mm3, 200, 1e-6) << "all of it is skin";
}

TEST(LookAt, MakesSomeLayersWhereThereIsSomebodyToMakeThem) {
  const FakeSlicing slicing(10);
  const FakePlanning planning;
  FakeRunners runners;
  JobInput input = Input();
  input.settings_text = "text";
  const auto found = Look({}, input, slicing, planning, runners);
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(runners.made, 10) << "of few layers all";
  EXPECT_NEAR(found->print_time_s, 130, 1e-6);
  EXPECT_NEAR(found->filament.length_mm, 50, 1e-6);
  EXPECT_EQ(found->layers, 10);

  runners.slots = 0;
  const auto alone = Look({}, input, slicing, planning, runners);
  ASSERT_TRUE(alone.ok()) << alone.status();
  EXPECT_EQ(runners.made, 10);
  EXPECT_EQ(alone->print_time_s, Look({}, input, slicing, planning)->print_time_s);
}

TEST(LookAt, AdvisesOrientationsOnRequest) {
  JobInput input = Input();
  EXPECT_TRUE(Look({}, input, FakeSlicing(10), FakePlanning())->orientations.empty());
  input.meshes.advise_orientations = true;
  EXPECT_EQ(Look({}, input, FakeSlicing(10), FakePlanning())->orientations.size(), 1);
}

TEST(LookAt, CountsCopies) {
  const auto found = Look({}, Input(), FakeSlicing(10, 3), FakePlanning());
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(found->layers, 10);
  EXPECT_DOUBLE_EQ(found->first_layer_area_mm2, 300);
  EXPECT_NEAR(found->filament.volume_mm3, 600, 1e-6);
}

TEST(LookAt, CompleteObjectsNeedAnOrderAndCoolEachByItself) {
  JobInput input = Input();
  FdmOf(input.settings).tools[0].cooling.slowdown_below_layer_time_s = 1'000;
  const auto together = Look({}, input, FakeSlicing(10, 3), FakePlanning());
  FdmOf(input.settings).machine.plan.sequence.complete_objects = true;
  const auto apart = Look({}, input, FakeSlicing(10, 3), FakePlanning());
  ASSERT_TRUE(apart.ok()) << apart.status();
  EXPECT_EQ(apart->layers, 30);
  EXPECT_DOUBLE_EQ(together->print_time_s, 10'000);
  EXPECT_DOUBLE_EQ(apart->print_time_s, 30'000);
  EXPECT_DOUBLE_EQ(apart->filament.volume_mm3, together->filament.volume_mm3);
  FakePlanning planning;
  planning.refuses = true;
  EXPECT_TRUE(Look({}, Input(), FakeSlicing(10), planning).ok());
  EXPECT_EQ(Look({}, input, FakeSlicing(10), planning).status().message(), "no order");
}

TEST(LookAt, NothingToPrintIsAnError) {
  EXPECT_EQ(DetailOf(Look({}, Input(), FakeSlicing(0), FakePlanning()).status()).reason,
            Reason::kNothingToPrint);
}

TEST(LookAt, CanBeCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(Look(call, Input(), FakeSlicing(1), FakePlanning()).status()));
}

TEST(LookAt, AProcessThatIsNotMadeHereIsAnError) {
  FakeRunners runners;
  const auto found = LookAt({}, Input(), FakeSlicing(1), JobPipeline({}, runners));
  EXPECT_EQ(DetailOf(found.status()).reason, Reason::kProcessUnavailable);
}

}  // namespace
}  // namespace slicefarm::coordinator::preflight_test
